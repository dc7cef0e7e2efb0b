// SPDX-License-Identifier: MIT
// The accuracy goals of quintic_isolate and of polished parameters against the exact foot
// points, on curves for which projectors have failed.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "core/evaluate/evaluation_test.hpp"
#include "core/project/kernel.hpp"
#include "reference/companion/projection.hpp"
#include "reference/exact_curve.hpp"

namespace bezierbench {
namespace {

struct Problem {
  int dimension;
  int degree;
  std::vector<double> points;
  std::vector<double> point;

  [[nodiscard]] CurveView<double> curve() const { return {Form::bernstein, dimension, degree, points}; }
  double& at(int i, int axis) { return points[static_cast<std::size_t>(i * dimension + axis)]; }
  [[nodiscard]] double largest() const {
    double largest = 0;
    for (const double x : points) largest = std::max(largest, std::abs(x));
    for (const double x : point) largest = std::max(largest, std::abs(x));
    return largest;
  }
};

/// The point of the curve at t, with rounding errors.
std::vector<double> on_curve(const Problem& problem, double t) {
  auto b = problem;
  for (int last = b.degree; last > 0; --last)
    for (int i = 0; i < last; ++i)
      for (int axis = 0; axis < b.dimension; ++axis) b.at(i, axis) += t * (b.at(i + 1, axis) - b.at(i, axis));
  b.points.resize(static_cast<std::size_t>(b.dimension));
  return b.points;
}

/// Makes C'(1/2) = 0 exactly: the curve has a cusp there.
void make_cusp(Problem& problem) {
  const int n = problem.degree;
  for (double& x : problem.points) x = std::floor(x * 1024);
  for (int axis = 0; axis < problem.dimension; ++axis) {
    double sum = 0;  // of C(n-1,j) (b_(j+1) - b_j), j >= 1
    double binomial = 1;
    for (int j = 1; j < n; ++j) {
      binomial = binomial * (n - j) / j;
      sum += binomial * (problem.at(j + 1, axis) - problem.at(j, axis));
    }
    problem.at(0, axis) = problem.at(1, axis) + sum;
  }
}

constexpr int kinds = 12;

void spoil(int kind, Problem& problem, Inputs& inputs) {
  const int n = problem.degree;
  const double t = inputs.unit();
  switch (kind) {
    case 0: break;                                        // random
    case 1: problem.point = on_curve(problem, t); break;  // on the curve
    case 2:                                               // next to it
      problem.point = on_curve(problem, t);
      problem.point[0] += std::ldexp(1, -static_cast<int>(inputs.unit() * 60));
      break;
    case 3:  // in a cusp
      if (n > 1) make_cusp(problem);
      problem.point = on_curve(problem, 0.5);
      break;
    case 4:  // next to a cusp
      if (n > 1) make_cusp(problem);
      problem.point = on_curve(problem, 0.5);
      problem.point[0] += std::ldexp(1, 9 - static_cast<int>(inputs.unit() * 60));
      break;
    case 5:  // mirrored, the point on the axis: two equally near points
      for (int i = 0; i <= n; ++i) problem.at(n - i, 0) = -problem.at(i, 0);
      for (int axis = 1; axis < problem.dimension; ++axis)
        for (int i = 0; i <= n; ++i) problem.at(n - i, axis) = problem.at(i, axis);
      problem.point[0] = 0;
      break;
    case 6:  // a line at constant speed: all leading coefficients of f vanish
      for (int axis = 0; axis < problem.dimension; ++axis)
        for (int i = 1; i <= n; ++i) problem.at(i, axis) = std::floor(9 * problem.at(0, axis)) + 3 * i;
      break;
    case 7:  // there and back again
      for (double& x : problem.points) x = std::floor(x * 4);
      for (double& x : problem.point) x = std::floor(x * 4);
      for (int axis = 1; axis < problem.dimension; ++axis)
        for (int i = 0; i <= n; ++i) problem.at(i, axis) = 2 * problem.at(i, 0);
      break;
    case 8:  // sizes far apart
      for (double& x : problem.points) x = std::ldexp(x, static_cast<int>(inputs.unit() * 60) - 30);
      break;
    case 9:  // far away from a small curve
      for (double& x : problem.point) x *= 0x1p+40;
      break;
    case 10:  // a small curve about the point
      for (std::size_t i = 0; i < problem.points.size(); ++i)
        problem.points[i] = problem.point[i % problem.point.size()] + 0x1p-45 * problem.points[i];
      break;
    default:  // small integers: coinciding control points, ties, roots at the ends
      for (double& x : problem.points) x = std::floor(x * 3);
      for (double& x : problem.point) x = std::floor(x * 3);
  }
}

/// 1,000 problems of each kind, degrees 1 to 7, one to three dimensions.
TEST(QuinticIsolate, NeverMissesTheFootPointOnNastyCurves) {
  Inputs inputs(11);
  double worst = 0;
  for (int trial = 0; trial < 1000 * kinds; ++trial) {
    const int d = 1 + trial % 3;
    const int n = trial % 5 < 3 ? 3 : 1 + trial % 7;
    Problem problem{d, n, inputs.coefficients(n, d), inputs.coefficients(0, d)};
    spoil(trial / 3 % kinds, problem, inputs);
    const auto exact = reference::projection(problem.curve(), problem.point);
    const auto& isolate = projection_kernels(d).front();
    ASSERT_EQ(isolate.info->id, "quintic_isolate");
    const auto foot = isolate.project(problem.curve(), problem.point);
    const double error = reference::distance_error(reference::binary64, foot.distance, exact.foot().distance_squared);
    const double units = problem.largest() == 0 ? error : error / (0x1p-52 * problem.largest());
    worst = std::max(worst, units);
    EXPECT_TRUE(foot.converged) << "trial " << trial;
    EXPECT_LE(units, 4) << "trial " << trial << " kind " << trial / 3 % kinds << " degree " << n << " d " << d;
    if (HasFailure() && units > 4) break;
  }
  RecordProperty("worst_units", std::to_string(worst));
}

/// 300 problems of each kind for every method that states a bound of the residual: t has the digits that f has.
TEST(Projection, KeepsTheBoundOfTheResidualOnNastyCurves) {
  Inputs inputs(13);
  for (int trial = 0; trial < 300 * kinds; ++trial) {
    const int d = 1 + trial % 3;
    const int n = trial % 5 < 3 ? 3 : 1 + trial % 7;
    Problem problem{d, n, inputs.coefficients(n, d), inputs.coefficients(0, d)};
    const int kind = trial / 3 % kinds;
    spoil(kind, problem, inputs);
    const auto exact = reference::projection(problem.curve(), problem.point);
    for (const auto& kernel : projection_kernels(d)) {
      if (kernel.residual_bound == nullptr) continue;
      const auto foot = kernel.project(problem.curve(), problem.point);
      EXPECT_LE(reference::foot_residual(foot.t, exact), kernel.residual_bound(n, d))
          << kernel.info->id << " trial " << trial << " kind " << kind << " degree " << n << " d " << d;
    }
  }
}

/// C - P cancels to the last digits of both, or beyond. The distance at t is still right up to its own rounding.
TEST(OffsetCurve, IsRightToItsOwnRoundingNextToTheCurve) {
  Inputs inputs(12);
  reference::ExactCurve exact;
  for (int trial = 0; trial < 300; ++trial) {
    const int d = 1 + trial % 3;
    const int n = 1 + trial % 6;
    Problem problem{d, n, inputs.coefficients(n, d), inputs.coefficients(0, d)};
    problem.point = on_curve(problem, inputs.unit());
    const auto foot = projection_kernels(d).front().project(problem.curve(), problem.point);
    const double truth = distance(exact.point(problem.curve(), foot.t), reference::exactly(problem.point));
    EXPECT_NEAR(foot.distance, truth, 0x1p-22 * truth + 0x1p-96) << "trial " << trial;  // truth has 24 bits
  }
}

}  // namespace
}  // namespace bezierbench
