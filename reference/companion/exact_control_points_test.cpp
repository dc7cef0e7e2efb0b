// SPDX-License-Identifier: MIT
#include "reference/companion/exact_control_points.hpp"

#include <gtest/gtest.h>

#include <random>

#include "reference/companion/exact_split.hpp"
#include "reference/exact_curve.hpp"

namespace bezierbench::reference {
namespace {

using Numbers = std::vector<double>;

/// A curve in the plane with coordinates, and weights of a rational one, that are integers of a few bits.
struct RandomCurve {
  RandomCurve(std::mt19937& random, int degree, bool rational) : n(degree) {
    for (int i = 0; i <= n; ++i) {
      for (int axis = 0; axis < 2; ++axis) points.push_back(static_cast<double>(random() % 64) - 32);
      if (rational) weights.push_back(static_cast<double>(1 + random() % 7));
    }
  }
  [[nodiscard]] CurveView<double> view() const {
    return {weights.empty() ? Form::bernstein : Form::rational, 2, n, points, weights};
  }

  int n;
  Numbers points;
  Numbers weights;
};

TEST(ExactControlPoints, TheWholeCurveAndItsReverse) {
  std::mt19937 random(1);
  for (int trial = 0; trial < 40; ++trial) {
    const RandomCurve curve(random, trial % 7, trial % 2 == 0);
    const auto whole = control_points_of_part(curve.view(), 0, 1);
    EXPECT_EQ(whole->points, curve.points);
    EXPECT_EQ(whole->weights, curve.weights);
    const auto reversed = control_points_of_part(curve.view(), 1, 0);
    const auto d = static_cast<std::size_t>(curve.n) * 2;
    for (std::size_t i = 0; i <= d; i += 2) {
      EXPECT_EQ(reversed->points[i], curve.points[d - i]);
      EXPECT_EQ(reversed->points[i + 1], curve.points[d - i + 1]);
    }
    EXPECT_EQ(reversed->weights, Numbers(curve.weights.rbegin(), curve.weights.rend()));
  }
}

/// Against sums of Bernstein polynomials, which share no triangle with it.
TEST(ExactControlPoints, HalvesAreThoseOfASplit) {
  std::mt19937 random(2);
  for (int trial = 0; trial < 40; ++trial) {
    const RandomCurve curve(random, 1 + trial % 7, trial % 2 == 0);
    const double t = static_cast<double>(1 + random() % 1000) / 1024;
    const auto halves = exact_split(curve.view(), t);
    const auto expect_half = [&](const ExactHalf& half, double from, double to) {
      const auto part = control_points_of_part(curve.view(), from, to);
      for (std::size_t i = 0; i < half.points.size(); ++i)
        for (int axis = 0; axis < 2; ++axis)
          EXPECT_EQ(part->points[2 * i + static_cast<std::size_t>(axis)],
                    round_to(binary64, half.points[i].coordinate(axis)));
      for (std::size_t i = 0; i < half.weights.size(); ++i)
        EXPECT_EQ(part->weights[i], round_to(binary64, half.weights[i]));
    };
    expect_half(halves.left, 0, t);
    expect_half(halves.right, t, 1);
  }
}

/// At parameters of 4 bits no part of a polynomial curve is rounded: at u it is the curve at from + (to - from) u.
TEST(ExactControlPoints, PartsAreTheCurve) {
  std::mt19937 random(3);
  for (int trial = 0; trial < 60; ++trial) {
    const RandomCurve curve(random, trial % 6, false);
    const double from = static_cast<double>(random() % 64) / 16 - 2;
    const double to = static_cast<double>(random() % 64) / 16 - 2;
    const auto part = control_points_of_part(curve.view(), from, to);
    for (const double u : {0.0, 0.25, 0.5, 0.875, 1.0, -3.0}) {
      const ExactPoint a = ExactCurve().point({Form::bernstein, 2, curve.n, part->points, {}}, u);
      const ExactPoint b = ExactCurve().point(curve.view(), from + (to - from) * u);
      EXPECT_EQ(distance(a, b), 0);
    }
  }
}

/// 252 is a multiple of every C(9, i), so that of a polynomial curve nothing is rounded.
TEST(ExactControlPoints, ElevatedCurvesAreTheCurve) {
  std::mt19937 random(4);
  for (int trial = 0; trial < 60; ++trial) {
    RandomCurve curve(random, trial % 10, trial % 2 == 0);
    if (curve.weights.empty())
      for (double& x : curve.points) x *= 252;
    for (double& w : curve.weights) w *= 252;
    const auto elevated = elevated_control_points(curve.view(), 9);
    const CurveView<double> result{curve.view().form, 2, 9, elevated->points, elevated->weights};
    for (const double t : {0.0, 0.25, 0.5, 0.875, 1.0}) {
      const ExactPoint a = ExactCurve().point(curve.view(), t);
      const ExactPoint b = ExactCurve().point(result, t);
      if (curve.weights.empty()) {
        EXPECT_EQ(distance(a, b), 0);
      } else {
        EXPECT_LT(distance(a, b), 1e-13);  // weights are exact, control points rounded
      }
    }
  }
}

TEST(ExactControlPoints, AWeightOfZeroIsRefused) {
  const Numbers points{1, 2, 4};
  const Numbers weights{1, 1, -1};  // w(t) = 1 - 2t^2, whose blossom at 0, t is 1 and at t, 1 is 1 - 2t
  const CurveView<double> curve{Form::rational, 1, 2, points, weights};
  EXPECT_FALSE(control_points_of_part(curve, 0.5, 1).has_value());
  EXPECT_TRUE(control_points_of_part(curve, 0.25, 0.5).has_value());
}

}  // namespace
}  // namespace bezierbench::reference
