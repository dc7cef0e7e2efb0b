// SPDX-License-Identifier: MIT
#include "experiments/run/blocks/share.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <utility>
#include <vector>

namespace bezierbench::run {
namespace {

/// Parts of unequal cost and nothing to do.
class Costs final : public Job {
 public:
  Costs(std::vector<double> costs, std::size_t each, bool timing)
      : costs_(std::move(costs)), each_(each), timing_(timing) {}
  [[nodiscard]] std::size_t parts() const override { return costs_.size(); }
  [[nodiscard]] std::size_t blocks_per_part() const override { return each_; }
  [[nodiscard]] double cost(std::size_t part) const override { return costs_[part]; }
  [[nodiscard]] bool exclusive() const override { return timing_; }
  [[nodiscard]] std::unique_ptr<Result> run_block(std::size_t) const override { return nullptr; }
  [[nodiscard]] std::unique_ptr<Result> read_result(number::ByteReader&) const override { return nullptr; }
  [[nodiscard]] Extent extent() const override { return {}; }
  void write(tables::Tables&) const override {}
  [[nodiscard]] std::vector<tables::Series> series() const override { return {}; }

 private:
  std::vector<double> costs_;
  std::size_t each_;
  bool timing_;
};

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

// More blocks than could be counted one by one.
TEST(Dealt, ManyBlocks) {
  const Costs job({1, 3}, std::size_t{1} << 50U, false);
  EXPECT_EQ(dealt(job, 0, {1, 2}).second, dealt(job, 0, {2, 2}).first);
  EXPECT_NEAR(cost_of(Costs({1, 3}, 1000, false), dealt(Costs({1, 3}, 1000, false), 0, {1, 2})), 2000, 3);
}

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
