// SPDX-License-Identifier: MIT
#include "experiments/cli/check/paired_times.hpp"

#include <gtest/gtest.h>

#include <vector>

namespace bezierbench::cli {
namespace {

using metric::Verdict;

/// Pairs that the machine disturbed alike: each takes another time, and so does its partner.
PairedTime after_times(double factor, std::size_t pairs) {
  std::vector<double> before;
  std::vector<double> after;
  for (std::size_t k = 0; k < pairs; ++k) {
    const double disturbed = 10 * (1 + static_cast<double>(k * k % 7));
    before.push_back(disturbed);
    after.push_back(factor * disturbed);
  }
  return paired_time({}, before, after);
}

TEST(PairedTimes, AreJudgedByTheirRatios) {
  EXPECT_EQ(after_times(1, 12).verdict, Verdict::same);
  EXPECT_EQ(after_times(1.02, 12).verdict, Verdict::slower);
  EXPECT_EQ(after_times(0.98, 12).verdict, Verdict::faster);
  EXPECT_DOUBLE_EQ(after_times(1.02, 12).ratio.median, 1.02);
}

TEST(PairedTimes, NeedEnoughPairsForAnInterval) {
  EXPECT_EQ(after_times(2, 7).verdict, Verdict::unresolved);
  EXPECT_EQ(after_times(2, 8).verdict, Verdict::slower);
}

TEST(PairedTimes, OnePairOfTwelveDecidesNothing) {
  std::vector<double> before(12, 10);
  auto after = before;
  after[3] = 1000;
  EXPECT_EQ(paired_time({}, before, after).verdict, Verdict::same);
}

}  // namespace
}  // namespace bezierbench::cli
