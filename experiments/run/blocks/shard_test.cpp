// SPDX-License-Identifier: MIT
#include "experiments/run/blocks/shard.hpp"

#include <gtest/gtest.h>

#include "experiments/run/costs_test.hpp"

namespace bezierbench::run {
namespace {

double cost_of(const Job& job, BlockSet::Run run) {
  double sum = 0;
  for (auto block = run.first; block < run.second; ++block) sum += job.cost(job.part_of(block));
  return sum;
}

TEST(Dealt, EveryBlockToOneShardAndAboutTheSameCostToEach) {
  const std::vector<double> costs{1, 100, 3, 3, 50, 0.1, 7};
  for (const std::size_t each : {1U, 2U, 7U, 100U})
    for (const bool timing : {false, true})
      for (std::size_t number = 0; number < 3; ++number)
        for (const std::uint64_t count : {1U, 2U, 3U, 8U, 50U}) {
          const Costs job(costs, each, timing);
          BlockSet seen;
          std::uint64_t sum = 0;
          for (std::uint64_t shard = 1; shard <= count; ++shard) {
            const auto run = dealt(job, number, {shard, count});
            ASSERT_LE(run.first, run.second);
            ASSERT_LE(run.second, job.blocks());
            seen.insert(run);
            sum += run.second - run.first;
            if (!timing) {
              EXPECT_LE(cost_of(job, run), job.total_cost() / static_cast<double>(count) + 100 * (1 + 1e-9));
            }
          }
          ASSERT_EQ(seen.size(), job.blocks());
          ASSERT_EQ(sum, job.blocks());
        }
}

TEST(Dealt, TimingsAreTheFirstShards) {
  const Costs job({1, 2, 3}, 1, true);
  for (std::size_t number = 0; number < 4; ++number) EXPECT_EQ(dealt(job, number, {1, 4}), BlockSet::Run(0, 3));
}

TEST(Dealt, SmallJobsGoRound) {
  std::vector<std::uint64_t> blocks(4);
  for (std::size_t number = 0; number < 8; ++number)
    for (std::uint64_t shard = 1; shard <= 4; ++shard) {
      const auto run = dealt(Costs({5}, 1, false), number, {shard, 4});
      blocks[shard - 1] += run.second - run.first;
    }
  EXPECT_EQ(blocks, (std::vector<std::uint64_t>{2, 2, 2, 2}));
}

}  // namespace
}  // namespace bezierbench::run
