// SPDX-License-Identifier: MIT
#include "experiments/run/blocks/share.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <map>
#include <memory>
#include <set>
#include <utility>
#include <vector>

#include "experiments/failure.hpp"

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

using Variables = std::map<std::string, std::string>;

std::pair<std::uint64_t, std::uint64_t> shard(std::string_view text, const Variables& variables = {}) {
  const auto found = shard_of(text, [&](const char* name) -> const char* {
    const auto entry = variables.find(name);
    return entry == variables.end() ? nullptr : entry->second.c_str();
  });
  return {found.number, found.count};
}

using Pair = std::pair<std::uint64_t, std::uint64_t>;

TEST(Shard, AsGiven) {
  EXPECT_EQ(shard("1/1"), Pair(1, 1));
  EXPECT_EQ(shard("3/12"), Pair(3, 12));
}

TEST(Shard, RefusesWhatIsNone) {
  for (const char* text : {"", "0/4", "5/4", "-1/4", "1", "/", "1/", "/4", "a/b", "1/0", "1.5/4", "1/4/2", "1/1e9",
                           "1/4294967298", "4294967297/4294967298", "1/99999999999999999999999", "automatic", "2 / 4"})
    EXPECT_THROW(shard(text), Failure) << text;
}

TEST(Shard, AutoReadsEveryLauncher) {
  EXPECT_EQ(shard("auto", {{"OMPI_COMM_WORLD_RANK", "0"}, {"OMPI_COMM_WORLD_SIZE", "4"}}), Pair(1, 4));
  EXPECT_EQ(shard("auto", {{"PMI_RANK", "3"}, {"PMI_SIZE", "4"}}), Pair(4, 4));
  EXPECT_EQ(shard("auto", {{"SLURM_PROCID", "2"}, {"SLURM_NTASKS", "5"}}), Pair(3, 5));
  const Variables array{{"SLURM_ARRAY_TASK_ID", "7"}, {"SLURM_ARRAY_TASK_MIN", "5"}, {"SLURM_ARRAY_TASK_COUNT", "6"}};
  EXPECT_EQ(shard("auto", array), Pair(3, 6));
}

// Every process of every job of the array gets its own number.
TEST(Shard, ArraysAndProcessesMultiply) {
  std::set<Pair> seen;
  for (const char* job : {"10", "11", "12"})
    for (const char* process : {"0", "1"})
      seen.insert(shard("auto", {{"SLURM_ARRAY_TASK_ID", job},
                                 {"SLURM_ARRAY_TASK_MIN", "10"},
                                 {"SLURM_ARRAY_TASK_COUNT", "3"},
                                 {"SLURM_PROCID", process},
                                 {"SLURM_NTASKS", "2"}}));
  EXPECT_EQ(seen, (std::set<Pair>{{1, 6}, {2, 6}, {3, 6}, {4, 6}, {5, 6}, {6, 6}}));
}

TEST(Shard, AutoRefusesWhatMakesNoSense) {
  EXPECT_THROW(shard("auto"), Failure);
  EXPECT_THROW(shard("auto", {{"PMI_RANK", "0"}}), Failure);
  EXPECT_THROW(shard("auto", {{"PMI_RANK", "4"}, {"PMI_SIZE", "4"}}), Failure);
  EXPECT_THROW(shard("auto", {{"PMI_RANK", "x"}, {"PMI_SIZE", "4"}}), Failure);
  const Variables gap{{"SLURM_ARRAY_TASK_ID", "9"}, {"SLURM_ARRAY_TASK_MIN", "1"}, {"SLURM_ARRAY_TASK_COUNT", "5"}};
  EXPECT_THROW(shard("auto", gap), Failure);
  // The product of these numbers does not fit 64 bits.
  const Variables many{{"SLURM_ARRAY_TASK_ID", "1"},
                       {"SLURM_ARRAY_TASK_MIN", "1"},
                       {"SLURM_ARRAY_TASK_COUNT", "4294967296"},
                       {"SLURM_PROCID", "0"},
                       {"SLURM_NTASKS", "4294967296"}};
  EXPECT_THROW(shard("auto", many), Failure);
  EXPECT_THROW(shard("auto", {{"PMI_RANK", "4294967297"}, {"PMI_SIZE", "4294967298"}}), Failure);
}

}  // namespace
}  // namespace bezierbench::run
