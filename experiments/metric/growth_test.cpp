// SPDX-License-Identifier: MIT
#include "experiments/metric/growth.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

namespace bezierbench::metric {
namespace {

constexpr double confidence = 0.99;
const std::vector<double> degrees{3, 5, 8, 10, 15, 20, 30};

std::vector<double> costs(double (*cost)(double n)) {
  std::vector<double> all;
  for (const double n : degrees) all.push_back(cost(n));
  return all;
}

TEST(Growth, FindsThePowerOfAPower) {
  const auto square = growth(degrees, costs([](double n) { return 7 * n * n; }), confidence);
  ASSERT_TRUE(square);
  EXPECT_NEAR(square->exponent, 2, 1e-12);
  EXPECT_NEAR(square->low, 2, 1e-10);
  EXPECT_NEAR(square->high, 2, 1e-10);
}

/// By hand: log n = 0, 1, 2 and log cost = 0, 1, 3 in units of log 2 give k = 3/2, S_xx = 2 and residuals 1/6, -1/3,
/// 1/6, so S_rr = 1/6; t_(1) at 99 % is 63.657 (tables of Student's t).
TEST(Growth, IntervalIsStudents) {
  const auto fitted = growth(std::vector<double>{1, 2, 4}, std::vector<double>{1, 2, 8}, confidence);
  ASSERT_TRUE(fitted);
  EXPECT_NEAR(fitted->exponent, 1.5, 1e-12);
  const double reach = 63.657 * std::sqrt((1.0 / 6) / 2);
  EXPECT_NEAR(fitted->high - fitted->exponent, reach, 1e-3);
  EXPECT_NEAR(fitted->exponent - fitted->low, reach, 1e-3);
}

TEST(Growth, NeedsThreeDegrees) {
  EXPECT_FALSE(growth(std::vector<double>{3, 5}, std::vector<double>{1, 2}, confidence));
  EXPECT_FALSE(growth(std::vector<double>{3, 5, 5}, std::vector<double>{1, 2, 2}, confidence));
  EXPECT_FALSE(growth(std::vector<double>{0, 3, 5}, std::vector<double>{1, 1, 2}, confidence));
  constexpr double inf = std::numeric_limits<double>::infinity();
  EXPECT_FALSE(growth(std::vector<double>{2, 3, 5}, std::vector<double>{inf, 1, 2}, confidence));
  EXPECT_FALSE(growth({}, {}, confidence));
}

TEST(Growth, AClaimIsABoundFromAbove) {
  EXPECT_EQ(verdict({2.02, 1.97, 2.07}, 2), GrowthVerdict::within);
  EXPECT_EQ(verdict({0.8, 0.7, 0.9}, 1), GrowthVerdict::within);
  EXPECT_EQ(verdict({1.5, 0.9, 2.1}, 1), GrowthVerdict::unresolved);
  EXPECT_EQ(verdict({2, 1.9, 2.1}, 1), GrowthVerdict::above);
}

}  // namespace
}  // namespace bezierbench::metric
