// SPDX-License-Identifier: MIT
#include "experiments/cli/commands/shard.hpp"

#include <gtest/gtest.h>

#include <map>
#include <set>

#include "experiments/failure.hpp"

namespace bezierbench::cli {
namespace {

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
}  // namespace bezierbench::cli
