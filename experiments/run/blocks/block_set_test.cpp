// SPDX-License-Identifier: MIT
#include "experiments/run/blocks/block_set.hpp"

#include <gtest/gtest.h>

#include <bitset>
#include <random>

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

}  // namespace
}  // namespace bezierbench::run
