// SPDX-License-Identifier: MIT
// Formula: f = x(t) - x, t <- t - 2 f f' / (2 f'^2 - f f''), inside a bracket that every sign of f narrows, from [x/4,
//   1], since x(t) <= 3 t; where the step leaves the bracket or is not a number, its middle, the geometric one while
//   the ends are far apart. It begins at t = x, and for x below 1/32 where the first of 3 x1 t, 3 x2 t^2 and t^3 is
//   about x. It ends before a step of at most u t, or where the bracket has no number inside.
// Cost: about 4 steps.
// Bound: none is stated. x(t) has a relative error of a few u, t one of x / (t x'(t)) times that.
// Fails: where x'(t) vanishes t has a third of the digits; y may go back by a few ulp between neighbouring x.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/easing/easing.hpp"

namespace bezierbench {

struct EasingHalley : EasingAsGiven {
  static constexpr MethodInfo info{.id = "easing_halley",
                                   .label = "Halley in a bracket",
                                   .problem = Problem::easing,
                                   .min_degree = 3,
                                   .max_degree = 3,
                                   .flops = "40 per step",
                                   .citation = "[Traub 1964], section 5.2; [Press et al. 2007], section 9.4"};

  template <class Scalar>
  static Eased<Scalar> solve(const EasingCurve<Scalar>& curve, Scalar x) {
    if (x == 0 || x == 1) return {x, x};
    constexpr Scalar u = std::numeric_limits<Scalar>::epsilon() / 2;
    Scalar low = x / 4;
    Scalar high = 1;
    Scalar t = start(curve, x);
    int steps = 0;
    while (steps < most_easing_steps) {
      const Scalar f = bernstein_cubic(curve.x1, curve.x2, t) - x;
      ++steps;
      if (f == 0) break;
      (f > 0 ? high : low) = t;
      const Scalar slope = bernstein_cubic_slope(curve.x1, curve.x2, t);
      const Scalar bend = 6 * ((1 - t) * (curve.x2 - 2 * curve.x1) + t * (1 - 2 * curve.x2 + curve.x1));
      Scalar next = t - 2 * f * slope / (2 * slope * slope - f * bend);
      if (std::abs(next - t) <= u * t) break;
      if (!(next > low && next < high))
        next = high > 4 * low ? std::sqrt(low) * std::sqrt(high) : low + (high - low) / 2;
      if (!(next > low && next < high)) break;
      t = next;
    }
    return {t, bernstein_cubic(curve.y1, curve.y2, t), steps, steps < most_easing_steps};
  }

 private:
  template <class Scalar>
  static Scalar start(const EasingCurve<Scalar>& curve, Scalar x) {
    if (x > Scalar(1) / 32) return x;
    const Scalar cube_root = std::ldexp(Scalar(1), std::ilogb(x) / 3);  // within a factor of 1.6
    return std::min({x / (3 * curve.x1), std::sqrt(x / (3 * curve.x2)), cube_root});
  }
};

}  // namespace bezierbench
