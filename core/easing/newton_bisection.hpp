// SPDX-License-Identifier: MIT
// Formula: at most 8 steps of Newton's method from t = x, until |x(t) - x| < 1e-7; where the slope or the steps do not
//   suffice, bisection of [0, 1], likewise from t = x.
// Bound: none is stated. |x(t) - x| < 1e-7 and rounding, and the error of y is that times the slope of the curve.
// Fails: y may go back between neighbouring x, since their last steps differ. In float the tolerance may be below the
//   rounding of x(t): then bisection would not end.
#pragma once

#include <cmath>

#include "core/easing/easing.hpp"

namespace bezierbench {

struct EasingNewtonBisection {
  static constexpr MethodInfo info{.id = "easing_newton_bisection",
                                   .label = "Newton, then bisection, as browsers",
                                   .problem = Problem::easing,
                                   .min_degree = 3,
                                   .max_degree = 3,
                                   .flops = "13 per Newton step, 8 per halving",
                                   .citation = "[WebKit 2008], solveCurveX; [Chromium 2014]"};

  template <class Scalar>
  static UnitCubics<Scalar> prepare(const EasingCurve<Scalar>& curve) {
    return UnitCubics<Scalar>(curve);
  }

  template <class Scalar>
  static Eased<Scalar> solve(const UnitCubics<Scalar>& curve, Scalar x) {
    constexpr auto tolerance = Scalar(1e-7);
    constexpr int most_newton_steps = 8;
    int steps = 0;
    Scalar t = x;
    while (steps < most_newton_steps) {
      const Scalar residual = curve.x.at(t) - x;
      if (std::abs(residual) < tolerance) return {t, curve.y.at(t), steps};
      const Scalar slope = curve.x.slope(t);
      if (std::abs(slope) < tolerance) break;
      t -= residual / slope;
      ++steps;
    }
    Scalar low = 0;
    Scalar high = 1;
    for (t = x; low < high && steps < most_easing_steps; ++steps) {
      const Scalar value = curve.x.at(t);
      if (std::abs(value - x) < tolerance) return {t, curve.y.at(t), steps};
      (x > value ? low : high) = t;
      t = low + (high - low) * Scalar(0.5);
    }
    return {t, curve.y.at(t), steps, steps < most_easing_steps};
  }
};

}  // namespace bezierbench
