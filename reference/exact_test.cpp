// SPDX-License-Identifier: MIT
#include "reference/exact.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace bezierbench {
namespace {

using testing::ElementsAre;

const std::vector<std::array<double, 2>> quadratic{{0, 0}, {1, 2}, {3, 1}};

TEST(Exact, IsTheNearestDouble) {
  EXPECT_THAT(exact(quadratic, 0.25), ElementsAre(0.5625, 0.8125));
  EXPECT_THAT(exact<Form::power>(quadratic, 0.5), ElementsAre(1.25, 1.25));
  // (1-t) 1 + t 2^53 = 2^53 (t + 2^-53 (1-t)) at t = 1 - 2^-53 is 2^53 - 1 + 2^-53
  const std::vector<std::array<double, 1>> line{{1.0}, {0x1p53}};
  EXPECT_EQ(exact(line, 1 - 0x1p-53)[0], 0x1p53 - 1);
  EXPECT_EQ(exact_error(line, 1 - 0x1p-53, {0x1p53 - 1})[0], 0x1p-53);
}

TEST(Exact, RoundsToFloatOnce) {
  // 1 + 2^-24 + 2^-60 lies above the middle of two floats; the nearest double lies on it, and the tie would go down.
  const std::vector<std::array<float, 1>> powers{{1.0F}, {0x1p-24F}, {0x1p-60F}};
  EXPECT_EQ(exact<Form::power>(powers, 1.0F)[0], 1 + 0x1p-23F);
  const std::vector<std::array<float, 1>> sum{{1 - 0x1p-24F}, {1 + 0x1p-23F}};
  // (1-t) (1 - 2^-24) + t (1 + 2^-23) = 1 - 2^-24 + 3 t 2^-24; at t = 1/3 rounded up to a float, just above 1
  const float third = 0x1.555556p-2F;
  EXPECT_EQ(exact(sum, third)[0], 1.0F);
  EXPECT_EQ(exact_error(sum, third, {1.0F})[0], 0x1p-49);  // 3 t - 1 = 2^-25
}

TEST(Exact, TakesAnyDimensionAndWeights) {
  const std::array<std::array<double, 5>, 2> line{{{0, 1, 2, 3, 4}, {1, 2, 3, 4, 5}}};
  EXPECT_THAT(exact(line, 0.5), ElementsAre(0.5, 1.5, 2.5, 3.5, 4.5));
  const std::array<std::array<double, 2>, 3> quarter{{{1, 0}, {1, 1}, {0, 1}}};
  EXPECT_THAT(exact(quarter, std::array<double, 3>{1, 1, 2}, 0.5), ElementsAre(0.6, 0.8));
  EXPECT_TRUE(std::isnan(exact(quarter, std::array<double, 3>{1, 0, -1}, 0.5)[0]));  // the weights sum to zero there
}

TEST(Exact, RefusesWhatIsNoNumber) {
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  const std::vector<std::array<double, 2>> none;
  EXPECT_THROW(exact(none, 0.5), std::invalid_argument);
  EXPECT_THROW(exact(quadratic, nan), std::invalid_argument);
  EXPECT_THROW(exact(std::vector<std::array<double, 1>>{{nan}}, 0.5), std::invalid_argument);
  EXPECT_THROW(exact(quadratic, std::vector<double>{1, nan, 1}, 0.5), std::invalid_argument);
  EXPECT_EQ(exact_error(quadratic, 0.5, {nan, 0})[0], std::numeric_limits<double>::infinity());
}

}  // namespace
}  // namespace bezierbench
