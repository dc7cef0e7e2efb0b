// SPDX-License-Identifier: MIT
// Every method on grids against the exact points: exact where nothing rounds, within its bound at every point, and how
// the error of forward differencing grows.
#include "core/grid/roster.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "core/evaluate/evaluation_test.hpp"
#include "core/grid/kernel.hpp"
#include "reference/error/trial_scale.hpp"
#include "reference/exact_curve.hpp"
#include "reference/exact_point.hpp"

namespace bezierbench {
namespace {

std::vector<double> points(const GridKernel& kernel, const CurveView<double>& curve, int steps) {
  std::vector<double> all(static_cast<std::size_t>((steps + 1) * curve.dimension));
  kernel.points(curve, steps, all.data());
  return all;
}

TEST(Grid, IsAPowerOfTwo) {
  EXPECT_TRUE(is_grid(1) && is_grid(64) && is_grid(max_grid_steps));
  EXPECT_FALSE(is_grid(0) || is_grid(-2) || is_grid(3) || is_grid(2 * max_grid_steps));
}

/// (t^3, 4 - 3t) at quarters: small integers over 64.
TEST(Grid, PointsOfACubicAreExactWhereNothingRounds) {
  const std::vector<double> in_powers{0, 4, 0, -3, 0, 0, 1, 0};
  const std::vector<double> control_points{0, 4, 0, 3, 0, 2, 1, 1};
  const std::vector<double> expected{0, 4, 0x1p-6, 3.25, 0x1p-3, 2.5, 27.0 / 64, 1.75, 1, 1};
  for (const auto& kernel : grid_kernels(2)) {
    const auto& coefficients = kernel.info->form == Form::power ? in_powers : control_points;
    const std::vector<double> weights(kernel.info->form == Form::rational ? 4 : 0, 2.0);
    EXPECT_EQ(points(kernel, {kernel.info->form, 2, 3, coefficients, weights}, 4), expected) << kernel.info->id;
  }
}

TEST(Grid, PointwiseHasTheBitsOfTheEvaluator) {
  Inputs inputs(3);
  const auto c = inputs.coefficients(5, 1);
  Curve<Form::bernstein, double, 1> curve(5);
  for (int i = 0; i <= 5; ++i) curve(0, i) = c[static_cast<std::size_t>(i)];
  const auto all = points(grid_kernels(1).front(), {Form::bernstein, 1, 5, c}, 32);
  for (int k = 0; k <= 32; ++k)
    EXPECT_EQ(all[static_cast<std::size_t>(k)], DeCasteljau::evaluate(curve, k / 32.0)[0]) << k;
}

/// Curves that lose digits or range, of one axis.
std::vector<double> nasty(int kind, int n, Inputs& inputs) {
  auto c = inputs.coefficients(n, 1);
  for (std::size_t i = 0; i < c.size(); ++i) switch (kind) {
      case 0: break;                                                                      // random
      case 1: c[i] = 1 + 0x1p-45 * c[i]; break;                                           // all close together
      case 2: c[i] = std::ldexp(c[i], static_cast<int>(inputs.unit() * 80) - 40); break;  // sizes far apart
      case 3: c[i] *= 0x1p-1060; break;                                                   // subnormal
      case 4: c[i] *= 0x1p+700; break;                                                    // huge
      case 5: c[i] = 0.1; break;                                                          // all equal
      default: c[i] = i % 2 == 0 ? 0.1 : -0.1;                                            // doubling back
    }
  return c;
}
constexpr int nasty_kinds = 7;

/// The largest error in u p~ over a grid, every point within its bound.
double judged(const GridKernel& kernel, const CurveView<double>& curve, int steps) {
  reference::ExactCurve exact;
  reference::TrialScale scale;
  const double u = reference::double_arithmetic.unit_roundoff;
  double largest = 0;
  for (const double c : curve.coefficients) largest = std::max(largest, std::abs(c));
  const double size = kernel.bound->underflow_scales_with_coefficients ? 1 + largest : 1;
  const double lost = kernel.bound->underflow(curve.degree, steps) * size * std::numeric_limits<double>::denorm_min();
  std::vector<double> magnitudes;
  for (const double c : curve.coefficients) magnitudes.push_back(std::abs(c));
  const auto all = points(kernel, curve, steps);
  double worst = 0;
  for (int k = 0; k <= steps; ++k) {
    const double t = static_cast<double>(k) / steps;
    const auto truth = exact.point(curve, t);
    const double error = reference::Distance(truth).to(std::span(all).subspan(static_cast<std::size_t>(k), 1));
    const double bound =
        kernel.bound->factor(curve.degree, k, u) * u * amplification(kernel.bound->amplification, magnitudes, t) + lost;
    if (!std::isfinite(error) || !std::isfinite(bound)) continue;
    EXPECT_FALSE(reference::TrialScale::violates(error, bound))
        << kernel.info->id << " degree " << curve.degree << " k " << k << " of " << steps << ": " << error << ", bound "
        << bound;
    scale.set(curve, t);
    worst = std::max(worst, scale.in_bound_units(error, reference::double_arithmetic));
  }
  return worst;
}

TEST(Grid, EveryPointKeepsItsBound) {
  Inputs inputs(4);
  for (int trial = 0; trial < 40 * nasty_kinds; ++trial) {
    const int n = static_cast<int>(inputs.unit() * (trial % 40 == 0 ? 40 : 9));
    const auto c = nasty(trial % nasty_kinds, n, inputs);
    const int steps = 1 << (trial % 8);
    for (const auto& kernel : grid_kernels(1))
      if (kernel.info->form != Form::rational) judged(kernel, {kernel.info->form, 1, n, c}, steps);
  }
}

/// Nothing underflows here, so that the bound is its factor times u p~.
TEST(Grid, EveryPointOfARationalCurveKeepsItsBound) {
  Inputs inputs(6);
  reference::ExactCurve exact;
  reference::TrialScale scale;
  int judged_points = 0;
  for (int trial = 0; trial < 60; ++trial) {
    const int n = trial % 7;
    const auto c = inputs.coefficients(n, 1);
    std::vector<double> weights;
    for (int i = 0; i <= n; ++i) weights.push_back(std::exp2(20 * inputs.symmetric()));
    const CurveView<double> curve{Form::rational, 1, n, c, weights};
    for (const auto& kernel : grid_kernels(1)) {
      if (kernel.info->form != Form::rational) continue;
      const auto all = points(kernel, curve, 16);
      for (int k = 0; k <= 16; ++k) {
        scale.set(curve, k / 16.0);
        const reference::Distance truth(exact.point(curve, k / 16.0));
        const double error = truth.to(std::span(all).subspan(static_cast<std::size_t>(k), 1));
        EXPECT_LE(scale.in_bound_units(error, reference::double_arithmetic),
                  kernel.bound->factor(n, k, reference::double_arithmetic.unit_roundoff));
        ++judged_points;
      }
    }
  }
  EXPECT_EQ(judged_points, 2 * 60 * 17);
}

/// Of random cubics, on grids of 64 and 4096 steps: evaluation point by point does not depend on the number of steps.
TEST(Grid, TheErrorOfForwardDifferencingGrowsWithTheSteps) {
  for (const auto& kernel : grid_kernels(1)) {
    if (kernel.info->form == Form::rational) continue;
    Inputs inputs(5);
    double coarse = 0;
    double fine = 0;
    for (int trial = 0; trial < 10; ++trial) {
      const auto c = inputs.coefficients(3, 1);
      const CurveView<double> curve{kernel.info->form, 1, 3, c};
      coarse = std::max(coarse, judged(kernel, curve, 64));
      fine = std::max(fine, judged(kernel, curve, 4096));
    }
    const bool grows = kernel.info->id == ForwardDifferencing::info.id;
    EXPECT_EQ(grows, fine > 4 * coarse) << kernel.info->id << ": " << coarse << " u p~ and " << fine << " u p~";
  }
}

}  // namespace
}  // namespace bezierbench
