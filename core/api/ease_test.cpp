// SPDX-License-Identifier: MIT
#include "core/api/ease.hpp"

#include <gtest/gtest.h>

#include <limits>

namespace bezierbench {
namespace {

/// x1 = x2 = 0 gives x = t^3, so t = 1/2 at 1/8, where y = (3 y1 + 3 y2 + 1) / 8.
TEST(EaseApi, KnownAnswers) {
  EXPECT_EQ(ease({0.0, 1.0, 0.0, 1.0}, 0.125), 0.875);
  EXPECT_EQ(ease({0.0F, 1.0F, 0.0F, 1.0F}, 0.125F), 0.875F);
  EXPECT_NEAR(ease<EasingNewtonBisection>({0.0, 1.0, 0.0, 1.0}, 0.125), 0.875, 1e-7);
  const EasingFunction<double> symmetric({0.42, 0, 0.58, 1});
  EXPECT_EQ(symmetric(0), 0);
  EXPECT_EQ(symmetric(0.5), 0.5);
  EXPECT_EQ(symmetric(1), 1);
}

TEST(EaseApi, GoesOnAlongTheTangents) {
  EXPECT_EQ(ease({0.5, 1.0, 0.5, 0.0}, -1.0), -2);  // through (x1, y1)
  EXPECT_EQ(ease({0.5, 1.0, 0.5, 0.0}, 2.0), 3);    // through (x2, y2)
}

TEST(EaseApi, RefusesWhatIsNoEasingCurve) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  EXPECT_THROW((void)ease({-0.1, 0.0, 0.5, 1.0}, 0.5), std::invalid_argument);
  EXPECT_THROW((void)ease({0.5, 0.0, 1.1, 1.0}, 0.5), std::invalid_argument);
  EXPECT_THROW((void)ease({0.5, infinity, 0.5, 1.0}, 0.5), std::invalid_argument);
  EXPECT_THROW((void)ease({0.5, 0.0, 0.5, 1.0}, infinity), std::invalid_argument);
  EXPECT_THROW((void)ease({0.5, 0.0, 0.5, 1.0}, std::numeric_limits<double>::quiet_NaN()), std::invalid_argument);
}

}  // namespace
}  // namespace bezierbench
