// SPDX-License-Identifier: MIT
#include "reference/companion/pole.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace bezierbench::reference {
namespace {

std::optional<double> pole_of(const std::vector<double>& weights, double from = 0, double to = 1) {
  const std::vector<double> points(weights.size(), 1.0);
  return pole({Form::rational, 1, static_cast<int>(weights.size()) - 1, points, weights}, from, to);
}

TEST(Pole, IsTheFirstRootOfTheDenominator) {
  EXPECT_EQ(pole_of({1, -3}), 0.25);
  EXPECT_EQ(pole_of({1, -1, 1}), 0.5);                                 // a double root
  EXPECT_NEAR(*pole_of({1, -2, 1}), (3 - std::sqrt(3.0)) / 6, 1e-15);  // 1 - 6t + 6t^2
  EXPECT_NEAR(*pole_of({1, -2, 1}, 0.5), (3 + std::sqrt(3.0)) / 6, 1e-15);
  EXPECT_EQ(pole_of({0, 1}), 0);
  EXPECT_EQ(pole_of({1, 0}), 1);
  EXPECT_EQ(pole_of({0, 0}), 0);
}

TEST(Pole, IsNoneWhereTheDenominatorKeepsItsSign) {
  EXPECT_EQ(pole_of({1, 2, 1}), std::nullopt);
  EXPECT_EQ(pole_of({-1, -2, -1}), std::nullopt);
  EXPECT_EQ(pole_of({1, -0.5, 1}), std::nullopt);
  EXPECT_EQ(pole_of({1, std::nextafter(-1.0, 0.0), 1}), std::nullopt);
  EXPECT_TRUE(pole_of({1, std::nextafter(-1.0, -2.0), 1}).has_value());
}

TEST(Pole, IsSoughtInThePartOnly) {
  EXPECT_EQ(pole_of({1, -3}, 0.25, 0.5), 0.25);
  EXPECT_EQ(pole_of({1, -3}, 0, 0.25), 0.25);
  EXPECT_EQ(pole_of({1, -3}, std::nextafter(0.25, 1), 0.5), std::nullopt);
  EXPECT_EQ(pole_of({1, -3}, 0, std::nextafter(0.25, 0)), std::nullopt);
  EXPECT_EQ(pole_of({1, -2}, 0, std::nextafter(1 / 3.0, 0)), std::nullopt);
  EXPECT_TRUE(pole_of({1, -2}, std::nextafter(1 / 3.0, 0), std::nextafter(1 / 3.0, 1)).has_value());
}

}  // namespace
}  // namespace bezierbench::reference
