// SPDX-License-Identifier: MIT
#include "reference/companion/easing.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace bezierbench::reference {
namespace {

constexpr double u = 0x1p-53;

/// x1 = x2 = 0 gives x = t^3; at x = 1/8 y = (3 y1 + 3 y2 + 1) / 8. (1, 0, 0, 1) has a triple root at x = 1/2.
TEST(ExactEased, KnownAnswers) {
  EXPECT_EQ(ExactEased(0, 1, 0, 1, 0.125).nearest(binary64), 0.875);
  EXPECT_EQ(ExactEased(0, 1, 0, 1, 0.125).t(), 0.5);
  EXPECT_EQ(ExactEased(1, 0, 0, 1, 0.5).nearest(binary64), 0.5);
  EXPECT_EQ(ExactEased(1, 0, 0, 1, 0).nearest(binary64), 0);
  EXPECT_EQ(ExactEased(1, 0, 0, 1, 1).nearest(binary64), 1);
  EXPECT_EQ(ExactEased(0.25, 0.25, 0.5, 0.5, 0.3).nearest(binary64), 0.3);
  EXPECT_EQ(ExactEased(0, 0, 0, 0, 0x1p-1074).nearest(binary64), 0x1p-1074);
}

/// The lines of css-easing-2: through the nearer inner point, the other one or the other end; flat where vertical.
TEST(ExactEased, GoesOnAsALine) {
  EXPECT_EQ(ExactEased(0.5, 1, 0.5, 0, -1).nearest(binary64), -2);
  EXPECT_EQ(ExactEased(0.5, 1, 0.5, 0, 2).nearest(binary64), 3);
  EXPECT_EQ(ExactEased(0, 0, 0.25, 0.5, -1).nearest(binary64), -2);
  EXPECT_EQ(ExactEased(0.5, 0.25, 1, 1, 2).nearest(binary64), 2.5);
  EXPECT_EQ(ExactEased(0, 0, 0, 0, -3).nearest(binary64), -3);
  EXPECT_EQ(ExactEased(1, 1, 1, 1, 2).nearest(binary64), 2);
  EXPECT_EQ(ExactEased(0, 1, 0.5, 0.5, -1).nearest(binary64), 0);
  EXPECT_EQ(ExactEased(1, 0.5, 1, 1, 2).nearest(binary64), 1);
  EXPECT_EQ(ExactEased(0.75, 1, 0.5, 0, -1).nearest(binary32), -4.0F / 3);
  EXPECT_EQ(ExactEased(0.5, 1, 0.5, 0, -1).error(-2.5), 0.5);
  EXPECT_EQ(ExactEased(0.5, 1, 0.5, 0, 2).t(), 1);
}

TEST(ExactEased, RoundsTiesToEven) {
  EXPECT_EQ(ExactEased(0, 1, 0, 4 * u, 0.125).nearest(binary64), 0.5 + 2 * u);   // 1/2 + 3 u / 2
  EXPECT_EQ(ExactEased(0, 1, 0, 12 * u, 0.125).nearest(binary64), 0.5 + 4 * u);  // 1/2 + 9 u / 2
}

TEST(ExactEased, ErrorsAreThoseOfTheDefinition) {
  ExactEased half(0, 1, 0, 4 * u, 0.125);  // y = 1/2 + 3 u / 2, and ulp(y) = u
  EXPECT_EQ(half.error(0.5), 1.5 * u);
  EXPECT_EQ(half.error_ulp(0.5, binary64), 1.5);
  ExactEased line(0.25, 0.25, 0.5, 0.5, 0.3);  // t is irrational, y is not
  EXPECT_EQ(line.error(0.3), 0);
  EXPECT_EQ(line.error(1.3), 1);
  ExactEased root(0, 1, 0, 1, 0.5);  // t = 2^(-1/3), y = 3 t - 3 t^2 + t^3
  const double t = std::cbrt(0.5);
  EXPECT_NEAR(root.nearest(binary64), 3 * t - 3 * t * t + 0.5, 1e-15);
  EXPECT_LE(root.error(root.nearest(binary64)), u / 2);
  EXPECT_LE(root.error_ulp(root.nearest(binary64), binary64), 0.5);
  EXPECT_LE(root.error_ulp(root.nearest(binary32), binary32), 0.5);
}

TEST(FloatEasing, EnclosesTheTruth) {
  std::mt19937 random(1);
  const auto unit = [&] { return static_cast<float>(random() >> 8U) * 0x1p-24F; };
  int decided = 0;
  for (int trial = 0; trial < 300; ++trial) {
    const float x1 = trial % 5 == 0 ? 1 : unit();
    const float x2 = trial % 5 == 0 ? 0 : unit();
    const float y1 = 4 * unit() - 2;
    const float y2 = 4 * unit() - 2;
    FloatEasing enclosing(x1, y1, x2, y2);
    const float x = std::ldexp(unit(), trial % 3 == 0 ? -static_cast<int>(random() % 100) : 0);
    const auto found = x > 0 && x < 1 ? enclosing.at(x) : std::nullopt;
    if (!found) continue;
    ++decided;
    ExactEased exact(x1, y1, x2, y2, x);
    EXPECT_LE(static_cast<double>(found->low), exact.nearest(binary64) + 0x1p-1074);
    EXPECT_GE(static_cast<double>(found->high), exact.nearest(binary64) - 0x1p-1074);
    if (static_cast<float>(found->low) == static_cast<float>(found->high)) {
      EXPECT_EQ(double{static_cast<float>(found->low)}, exact.nearest(binary32)) << trial;
    }
  }
  EXPECT_GT(decided, 280);
}

}  // namespace
}  // namespace bezierbench::reference
