// SPDX-License-Identifier: MIT
#include "core/api/flatten.hpp"

#include <gtest/gtest.h>

namespace bezierbench {
namespace {

using Points = std::vector<std::array<double, 2>>;

/// The apex of the parabola is (1, 1); two chords are 1/4 / sqrt(2) away.
TEST(FlattenApi, OfAParabola) {
  const Points parabola{{0, 0}, {1, 2}, {2, 0}};
  EXPECT_EQ(flatten<WangCount>(parabola, 0.25), (Points{{0, 0}, {1, 1}, {2, 0}}));
  for (const auto& ends : {flatten(parabola, 0.25), flatten(std::array{parabola[0], parabola[1], parabola[2]}, 0.25)}) {
    ASSERT_EQ(ends.size(), 3U);
    EXPECT_EQ(ends.front(), parabola.front());
    EXPECT_NEAR(ends[1][0], 1, 1e-15);
    EXPECT_NEAR(ends[1][1], 1, 1e-15);
    EXPECT_EQ(ends.back(), parabola.back());
  }
}

TEST(FlattenApi, TakesHigherDegreesAndRefusesWhatItCannotDo) {
  const Points quartic{{0, 0}, {1, 2}, {2, 0}, {3, 1}, {4, 4}};
  EXPECT_EQ(flatten(quartic, 1e-3), flatten<Halving<DistanceCriterion>>(quartic, 1e-3));
  EXPECT_THROW((void)flatten<EqualErrors>(quartic, 1e-3), std::invalid_argument);
  EXPECT_THROW((void)flatten(quartic, 0), std::invalid_argument);
  EXPECT_THROW((void)flatten(Points{{1, 1}}, 0.1), std::invalid_argument);
  EXPECT_THROW((void)flatten(Points{{0, 0}, {1, 2}, {2, 0}}, 1e-18), std::invalid_argument);
}

/// The inner control points of its two halves are 0.159 from their chords.
TEST(FlattenApi, OfAQuarterCircle) {
  const Points points{{1, 0}, {1, 1}, {0, 1}};
  const std::vector<double> weights{1, std::sqrt(0.5), 1};
  const auto ends = flatten(points, weights, 0.16);
  ASSERT_EQ(ends.size(), 3U);
  EXPECT_NEAR(ends[1][0], std::sqrt(0.5), 1e-15);
  EXPECT_NEAR(ends[1][1], std::sqrt(0.5), 1e-15);
  EXPECT_THROW((void)flatten(points, std::vector<double>{1, 1}, 0.16), std::invalid_argument);
}

}  // namespace
}  // namespace bezierbench
