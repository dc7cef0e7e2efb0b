// SPDX-License-Identifier: MIT
#include "experiments/metric/order_statistics.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <numeric>
#include <vector>

namespace bezierbench::metric {
namespace {

std::vector<double> one_to(int count) {
  std::vector<double> values(static_cast<std::size_t>(count));
  std::iota(values.begin(), values.end(), 1);
  return values;
}

TEST(OrderStatistics, QuantilesAreNearestRanks) {
  const auto values = one_to(400);
  EXPECT_EQ(quantile(values, 0.05), 20);
  EXPECT_EQ(quantile(values, 0.95), 380);
  EXPECT_EQ(quantile(values, 1), 400);
  EXPECT_EQ(quantile(std::vector<double>{7}, 0.05), 7);
}

TEST(OrderStatistics, MediansOfEvenSamplesAreHalfWayBetweenTheMiddleTwo) {
  EXPECT_EQ(median(std::vector<double>{9, 1, 2}), 2);
  EXPECT_EQ(median(std::vector<double>{9, 1, 2, 4}), 3);
}

/// Tabulated intervals of the sign test (Conover, Practical Nonparametric Statistics, table A3): for N = 10 at 95 % the
/// 2nd and 9th, and for N = 20 the 6th and 15th order statistics.
TEST(OrderStatistics, MedianIntervalsAreTheTabulatedOnes) {
  const auto ten = median_interval(one_to(10), 0.95);
  EXPECT_EQ(ten.low, 2);
  EXPECT_EQ(ten.high, 9);
  EXPECT_EQ(ten.median, 5.5);
  const auto twenty = median_interval(one_to(20), 0.95);
  EXPECT_EQ(twenty.low, 6);
  EXPECT_EQ(twenty.high, 15);
}

TEST(OrderStatistics, TooFewValuesGiveTheWholeRange) {
  const auto three = median_interval(one_to(3), 0.99);
  EXPECT_EQ(three.low, 1);
  EXPECT_EQ(three.high, 3);
}

/// Of 2 values none is below the quarter with 9/16, one with 6/16 and both with 1/16: the first value exceeds it where
/// none is below, and lies below it otherwise.
TEST(OrderStatistics, RanksOfAQuantileFollowTheBinomialDistribution) {
  const auto ranks = [](std::size_t count, unsigned long part, unsigned long exceptions) {
    const Ranks found = quantile_ranks(count, part, exceptions);
    return std::pair(found.low, found.high);
  };
  EXPECT_EQ(ranks(2, 4, 16), std::pair(std::size_t{0}, std::size_t{2}));  // P(both below) = 1/16
  EXPECT_EQ(ranks(2, 4, 17), std::pair(std::size_t{0}, std::size_t{3}));
  EXPECT_EQ(ranks(2, 4, 2), std::pair(std::size_t{0}, std::size_t{1}));  // P(none below) = 9/16, P(any below) = 7/16
  // The sign test again: 2 and 9 of 10, 6 and 15 of 20 (Conover, table A3).
  EXPECT_EQ(ranks(10, 2, 40), std::pair(std::size_t{2}, std::size_t{9}));
  EXPECT_EQ(ranks(20, 2, 40), std::pair(std::size_t{6}, std::size_t{15}));
  // By fractions in Python, from math.comb: the first sample that has a value below its 5 % quantile is of 104.
  EXPECT_EQ(ranks(103, 20, 200), std::pair(std::size_t{0}, std::size_t{13}));
  EXPECT_EQ(ranks(104, 20, 200), std::pair(std::size_t{1}, std::size_t{13}));
  EXPECT_EQ(ranks(400, 20, 200), std::pair(std::size_t{10}, std::size_t{33}));
}

/// 2 (1/2)^7 = 0.0156 and 2 (1/2)^8 = 0.0078.
TEST(OrderStatistics, EightValuesCoverAtNinetyNinePercent) {
  EXPECT_FALSE(covers_median(0, 0.99));
  EXPECT_FALSE(covers_median(7, 0.99));
  EXPECT_TRUE(covers_median(8, 0.99));
  EXPECT_TRUE(covers_median(41, 0.99));
}

TEST(Verdict, FollowsTheInterval) {
  EXPECT_EQ(verdict({1, 0.99, 1.01}), Verdict::same);
  EXPECT_EQ(verdict({1, 0.9899, 1.01}), Verdict::unresolved);
  EXPECT_EQ(verdict({1, 0.99, 1.0101}), Verdict::unresolved);
  EXPECT_EQ(verdict({1.02, 1.01, 1.03}), Verdict::unresolved);
  EXPECT_EQ(verdict({1.02, 1.0101, 1.03}), Verdict::slower);
  EXPECT_EQ(verdict({0.98, 0.97, 0.99}), Verdict::unresolved);
  EXPECT_EQ(verdict({0.98, 0.97, 0.9899}), Verdict::faster);
  EXPECT_EQ(verdict({1, 0.5, 2}), Verdict::unresolved);
  EXPECT_EQ(verdict({1.2, 1.1, 1.3}, 0.5), Verdict::same);
}

TEST(Verdict, NotANumberIsUnresolved) {
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(verdict({nan, nan, nan}), Verdict::unresolved);
  EXPECT_EQ(verdict({1, nan, 1}), Verdict::unresolved);
  EXPECT_EQ(verdict({1, 1, nan}), Verdict::unresolved);
}

}  // namespace
}  // namespace bezierbench::metric
