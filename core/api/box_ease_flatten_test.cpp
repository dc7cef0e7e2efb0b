// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

#include "core/api/box.hpp"
#include "core/api/ease.hpp"
#include "core/api/flatten.hpp"

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

namespace {

using Points = std::vector<std::array<double, 2>>;

/// A side that contains `tightest` and is not farther than `most` from it.
void expect_side(double side, double tightest, double most) {
  EXPECT_GE(side, tightest);
  EXPECT_LE(side, tightest + most);
}

/// The apex of the parabola is (1, 1).
TEST(BoxApi, OfAParabola) {
  const Points parabola{{0, 0}, {1, 2}, {2, 0}};
  for (const auto& sides : {box(parabola), box(std::array{parabola[0], parabola[1], parabola[2]}),
                            box<ExactBox<Form::bernstein>>(parabola)}) {
    EXPECT_EQ(sides[0].low, 0);
    EXPECT_EQ(sides[0].high, 2);
    EXPECT_EQ(sides[1].low, 0);
    expect_side(sides[1].high, 1, 1e-12);
  }
  EXPECT_EQ(box<ControlBox<Form::bernstein>>(parabola)[1].high, 2);
}

/// An arc of the circle x^2 + y^2 = 15^2, whose top is (0, 15).
TEST(BoxApi, OfAnArc) {
  const Points arc{{-12, 9}, {0, 25}, {12, 9}};
  const auto sides = box(arc, std::vector<double>{5, 3, 5});
  EXPECT_EQ(sides[0].low, -12);
  EXPECT_EQ(sides[0].high, 12);
  EXPECT_EQ(sides[1].low, 9);
  expect_side(sides[1].high, 15, 0x1p-49);  // the next double
  EXPECT_EQ(box(arc, std::vector<double>{5, -3, 5})[1].high, std::numeric_limits<double>::infinity());
}

TEST(BoxApi, RefusesWhatItCannotDo) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const Points line{{0, 0}, {1, 1}};
  EXPECT_THROW((void)box(Points{}), std::invalid_argument);
  EXPECT_THROW((void)box(Points{{0, 0}, {1, nan}}), std::invalid_argument);
  EXPECT_THROW((void)box<QuadraticFormulaBox<false>>(Points(9)), std::invalid_argument);
  EXPECT_THROW((void)box(line, std::vector<double>{1}), std::invalid_argument);
  EXPECT_THROW((void)box(line, std::vector<double>{0, 0}), std::invalid_argument);
  EXPECT_THROW((void)box(line, std::vector<double>{1, nan}), std::invalid_argument);
}

}  // namespace

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
