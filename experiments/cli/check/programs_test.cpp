// SPDX-License-Identifier: MIT
#include "experiments/cli/check/programs.hpp"

#include <gtest/gtest.h>

namespace bezierbench::cli {
namespace {

using metric::Verdict;

/// Pairs that the machine disturbed alike: each takes another time, and so does its partner.
PairedTimes after_times(double factor, std::size_t pairs) {
  PairedTimes times;
  for (std::size_t k = 0; k < pairs; ++k) {
    const double disturbed = 10 * (1 + static_cast<double>(k * k % 7));
    times.before.push_back(disturbed);
    times.after.push_back(factor * disturbed);
  }
  return times;
}

TEST(PairedTimes, AreJudgedByTheirRatios) {
  EXPECT_EQ(after_times(1, 12).verdict(), Verdict::same);
  EXPECT_EQ(after_times(1.02, 12).verdict(), Verdict::slower);
  EXPECT_EQ(after_times(0.98, 12).verdict(), Verdict::faster);
  EXPECT_DOUBLE_EQ(after_times(1.02, 12).ratio().median, 1.02);
}

TEST(PairedTimes, RequireEnoughPairsForAnInterval) {
  EXPECT_EQ(after_times(2, 7).verdict(), Verdict::unresolved);
  EXPECT_EQ(after_times(2, 8).verdict(), Verdict::slower);
}

TEST(PairedTimes, OnePairOfTwelveDecidesNothing) {
  PairedTimes times{std::vector<double>(12, 10), std::vector<double>(12, 10)};
  times.after[3] = 1000;
  EXPECT_EQ(times.verdict(), Verdict::same);
}

}  // namespace
}  // namespace bezierbench::cli
