// SPDX-License-Identifier: MIT
#include "experiments/run/blocks/block_order.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "experiments/run/costs_test.hpp"

namespace bezierbench::run {
namespace {

std::vector<BlockSet::Run> all_blocks(const Jobs& jobs) {
  std::vector<BlockSet::Run> runs;
  for (const auto& job : jobs) runs.emplace_back(0, job->blocks());
  return runs;
}

// The second repetition of the first study comes after the first one of the last.
TEST(ExclusiveOrder, SpreadsTheBlocksOfAPartOverAllJobs) {
  Jobs jobs;
  jobs.push_back(std::make_unique<Costs>(std::vector<double>(2, 1.0), 3, true));
  jobs.push_back(std::make_unique<Costs>(std::vector<double>(1, 1.0), 3, false));
  jobs.push_back(std::make_unique<Costs>(std::vector<double>(1, 1.0), 2, true));
  EXPECT_THAT(exclusive_order(jobs, all_blocks(jobs)),
              testing::ElementsAre(BlockOfJob{0, 0}, BlockOfJob{0, 3}, BlockOfJob{2, 0},  //
                                   BlockOfJob{0, 1}, BlockOfJob{0, 4}, BlockOfJob{2, 1},  //
                                   BlockOfJob{0, 2}, BlockOfJob{0, 5}));
}

TEST(ExclusiveOrder, TakesOnlyWhatIsDealt) {
  Jobs jobs;
  jobs.push_back(std::make_unique<Costs>(std::vector<double>(2, 1.0), 2, true));
  EXPECT_TRUE(exclusive_order(jobs, std::vector<BlockSet::Run>{{0, 0}}).empty());
  EXPECT_EQ(exclusive_order(jobs, all_blocks(jobs)).size(), 4U);
}

}  // namespace
}  // namespace bezierbench::run
