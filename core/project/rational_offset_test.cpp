// SPDX-License-Identifier: MIT
// Foot points on rational curves: known ones, and no point of the curve nearer than the truth says.
#include "core/project/rational_offset.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "core/evaluate/evaluation_test.hpp"
#include "core/project/kernel.hpp"
#include "core/project/subdivide_hull.hpp"
#include "reference/companion/exact_roots.hpp"
#include "reference/companion/projection.hpp"
#include "reference/exact_curve.hpp"

namespace bezierbench {
namespace {

std::vector<ProjectionKernel> rational_methods(int dimension) {
  std::vector<ProjectionKernel> methods;
  for (const auto& kernel : projection_kernels(dimension))
    if (kernel.info->form == Form::rational) methods.push_back(kernel);
  EXPECT_GE(methods.size(), 3U);
  return methods;
}

/// On the circle ((1 - t^2) / (1 + t^2), 2t / (1 + t^2)) the foot of r (cos a, sin a) is at tan(a / 2), |r - 1| away.
TEST(RationalProjection, OntoTheQuarterCircle) {
  for (const double size : {0x1p-1000, 1.0, 0x1p+1000})
    for (const double weight : {1.0, -0x1p-600}) {
      const std::vector<double> points{size, 0, size, size, 0, size};
      const std::vector<double> weights{weight, weight, 2 * weight};
      const CurveView<double> circle{Form::rational, 2, 2, points, weights};
      for (const auto& kernel : rational_methods(2)) {
        for (const double angle : {0.1, 0.7, 1.5})
          for (const double radius : {0.25, 1.0, 7.0}) {
            const std::vector<double> point{radius * std::cos(angle) * size, radius * std::sin(angle) * size};
            const auto foot = kernel.project(circle, point);
            EXPECT_TRUE(foot.converged) << kernel.info->id;
            EXPECT_NEAR(foot.t, std::tan(angle / 2), 1e-14) << kernel.info->id << " " << radius;
            EXPECT_NEAR(foot.distance / size, std::abs(radius - 1), 4e-15) << kernel.info->id;
          }
        const std::vector<double> centre{0, 0};
        EXPECT_NEAR(kernel.project(circle, centre).distance / size, 1, 1e-15) << kernel.info->id;
        const std::vector<double> behind{-size, -size};
        EXPECT_NEAR(kernel.project(circle, behind).distance / size, std::sqrt(5.0), 1e-14);
      }
    }
}

/// Weights of one size, over forty binades and of both signs; points anywhere and next to the curve.
TEST(RationalProjection, SubdivisionMissesNothing) {
  Inputs inputs(21);
  reference::ExactCurve exact_curve;
  int with_signs = 0;
  int unconverged = 0;
  for (int trial = 0; trial < 1500; ++trial) {
    const int d = 1 + trial % 3;
    const int n = 1 + trial % 6;
    const auto points = inputs.coefficients(n, d);
    auto point = inputs.coefficients(0, d);
    std::vector<double> weights;
    for (int i = 0; i <= n; ++i) {
      const double mild = 1 + inputs.unit();
      const double wild = std::ldexp(mild, static_cast<int>(20 * inputs.symmetric()));
      const bool inside = i > 0 && i < n;
      weights.push_back(trial % 4 == 1 ? wild : trial % 4 == 3 && inside ? inputs.symmetric() : mild);
    }
    const CurveView<double> curve{Form::rational, d, n, points, weights};
    if (reference::pole(curve)) continue;
    with_signs += std::ranges::any_of(weights, [](double w) { return w < 0; }) ? 1 : 0;
    if (trial % 5 == 0) {
      const auto& on_curve = exact_curve.point(curve, inputs.unit());
      for (int axis = 0; axis < d; ++axis)
        point[static_cast<std::size_t>(axis)] = reference::round_to(reference::binary64, on_curve.coordinate(axis));
    }
    const auto truth = reference::projection(curve, point);
    for (const auto& kernel : rational_methods(d)) {
      const auto foot = kernel.project(curve, point);
      const double error = reference::distance_error(reference::binary64, foot.distance, truth.foot().distance_squared);
      const double least = reference::square_root(reference::binary64, truth.foot().distance_squared);
      const auto what = std::string(kernel.info->id) + " trial " + std::to_string(trial);
      EXPECT_GE(foot.distance, least - 0x1p-46) << what;
      if (kernel.info->id != "subdivide_hull") continue;
      // Where few weights dominate, the curve passes most of its length between two neighbouring t.
      if (foot.converged) {
        EXPECT_LE(error, trial % 4 == 3 ? 0x1p-40 : 0x1p-46) << what;
      }
      unconverged += foot.converged ? 0 : 1;
    }
  }
  EXPECT_GT(with_signs, 50);
  EXPECT_GT(unconverged, 0);
  EXPECT_LT(unconverged, 30);
}

/// All points have x = 10, so that the foot of (1, 0) is (10, 0), in the part where all weights are small. There 1 - t
/// is the weight to the power of 1 / n, and doubles t are close enough together where that is at least 2^-30.
TEST(RationalProjection, SubdivisionKnowsWherePartsOfTheCurveHaveSmallWeights) {
  const auto project = [](int n, double weight) {
    Curve<Form::rational, double, 2> curve(n);
    for (int i = 0; i <= n; ++i) {
      curve.points(0, i) = 10;
      curve.points(1, i) = 10 - 20.0 * i / n;
      curve.weights[i] = i == 0 ? 1 : weight;
    }
    return ProjectionOfRational<SubdivideHull>::project(curve, Point<double, 2>(1, 0));
  };
  for (const int n : {2, 3, 7, 15, 40})
    for (const double weight : {1e-5, 1e-30, 1e-100, 1e-200, 1e-265, 1e-300}) {
      const auto foot = project(n, weight);
      const auto what = std::to_string(n) + " " + std::to_string(weight);
      if (foot.converged) {
        EXPECT_NEAR(foot.distance, 9, 1e-10) << what;
      }
      if (weight > std::ldexp(1, -30 * n) && weight > 1e-271) {
        EXPECT_TRUE(foot.converged) << what;
      }
      if (weight < 1e-271) {
        EXPECT_FALSE(foot.converged) << what;
      }
    }
}

/// W is 4e-16 of the largest weight at its least, so that computed distances have no digits there.
TEST(RationalProjection, NextToAPoleSubdivisionSaysThatItDoesNotKnow) {
  Curve<Form::rational, double, 2> curve(2);
  const double x[] = {9.2540181397442341e-18, 9.2540181397442341e-18, 0};
  const double weights[] = {1, -7.1650473098150336, 51.337902951892524};
  for (int i = 0; i <= 2; ++i) {
    curve.points(0, i) = x[i];
    curve.points(1, i) = 0;
    curve.weights[i] = weights[i];
  }
  EXPECT_FALSE(ProjectionOfRational<SubdivideHull>::project(curve, Point<double, 2>(0.65908621577795845, 0)).converged);
}

TEST(RationalProjection, OntoACurveThatIsAPoint) {
  const std::vector<double> points{1, 2, 3, 1, 2, 3, 1, 2, 3};
  const std::vector<double> weights{1, -0.5, 1};
  for (const auto& kernel : rational_methods(3)) {
    const std::vector<double> point{3, 4, 4};
    EXPECT_NEAR(kernel.project({Form::rational, 3, 2, points, weights}, point).distance, 3, 1e-15) << kernel.info->id;
  }
}

}  // namespace
}  // namespace bezierbench
