// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <array>
#include <bitset>
#include <random>
#include <set>
#include <utility>
#include <vector>

#include "experiments/run/blocks/checkpoints.hpp"
#include "experiments/run/blocks/trial_blocks.hpp"

namespace bezierbench::run {
namespace {

constexpr std::size_t universe = 40;
using Plain = std::bitset<universe>;

BlockSet::Run random_run(std::mt19937_64& random) {
  const auto first = random() % universe;
  return {first, std::min<std::uint64_t>(universe, first + random() % 6)};
}

Plain plain(BlockSet::Run run) {
  Plain bits;
  for (auto block = run.first; block < run.second; ++block) bits.set(block);
  return bits;
}

// Against the obvious set of bits.
TEST(BlockSet, IsASet) {
  std::mt19937_64 random(1);
  for (int round = 0; round < 2000; ++round) {
    BlockSet set;
    Plain expected;
    for (auto inserts = random() % 12; inserts > 0; --inserts) {
      const auto run = random_run(random);
      set.insert(run);
      expected |= plain(run);
    }
    ASSERT_EQ(set.size(), expected.count());
    ASSERT_EQ(set.empty(), expected.none());
    for (std::size_t block = 0; block < universe; ++block) ASSERT_EQ(set.contains(block), expected.test(block));
    const auto probe = random_run(random);
    ASSERT_EQ(set.overlaps(probe), (expected & plain(probe)).any());
    BlockSet other;
    other.insert(probe);
    ASSERT_EQ(set.overlaps(other), (expected & plain(probe)).any());
    ASSERT_EQ(set.within(probe).size(), (expected & plain(probe)).count());
    for (const auto& run : set.within(probe).runs()) ASSERT_TRUE((plain(run) & ~(expected & plain(probe))).none());
    Plain again;
    std::uint64_t last = 0;
    for (const auto& run : set.runs()) {
      ASSERT_TRUE(again.none() || run.first > last);  // ascending, with a gap between
      last = run.second;
      again |= plain(run);
    }
    ASSERT_EQ(again, expected);
    set.insert(other);
    ASSERT_EQ(set.size(), (expected | plain(probe)).count());
    ASSERT_EQ(BlockSet(set.runs()).runs(), set.runs());
  }
}

/// Whatever the sizes: every trial of every replicate is in one block, and no block is empty or longer than the most.
TEST(TrialBlocks, EveryTrialIsInExactlyOneBlock) {
  for (const auto& [trials, replicates, most] :
       std::vector<std::array<std::int64_t, 3>>{{1, 1, 1}, {7, 3, 2}, {8, 3, 2}, {5, 2, 100}, {1, 4, 3}}) {
    const TrialBlocks blocks(trials, replicates, most);
    std::set<std::pair<std::int64_t, std::int64_t>> seen;
    for (std::size_t k = 0; k < blocks.count(); ++k) {
      const auto block = blocks[k];
      EXPECT_LT(block.first, block.end);
      EXPECT_LE(block.end - block.first, blocks.full());
      each_trial(block, [&](std::int64_t trial) { EXPECT_TRUE(seen.emplace(block.replicate, trial).second); });
    }
    EXPECT_EQ(seen.size(), static_cast<std::size_t>(trials * replicates));
    EXPECT_LE(blocks.full(), most);
    EXPECT_EQ(seen.begin()->second, 0);
    EXPECT_EQ(*seen.rbegin(), std::pair(replicates - 1, trials - 1));
  }
}

TEST(TrialBlocks, GroupsEndWithTheBlock) {
  std::vector<std::pair<std::int64_t, std::int64_t>> groups;
  each_group({0, 10, 25}, 8, [&](std::int64_t first, std::int64_t count) { groups.emplace_back(first, count); });
  EXPECT_EQ(groups, (std::vector<std::pair<std::int64_t, std::int64_t>>{{10, 8}, {18, 7}}));
}

}  // namespace
}  // namespace bezierbench::run
