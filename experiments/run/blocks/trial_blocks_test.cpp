// SPDX-License-Identifier: MIT
#include "experiments/run/blocks/trial_blocks.hpp"

#include <gtest/gtest.h>

#include <array>
#include <set>
#include <utility>
#include <vector>

namespace bezierbench::run {
namespace {

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
