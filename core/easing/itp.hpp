// SPDX-License-Identifier: MIT
// Formula: a bracket [a, b] of the root, from [0, 1]. The secant's point is moved towards the middle by k1 (b-a)^2,
//   then projected into a distance of the middle that leaves bisection's worst case; the sign there gives the next
//   bracket. It ends when b - a <= 2 e, e = u; t is the middle.
// Source: with k1 = 0.2, k2 = 2 and n0 = 1.
// Cost: at most log2(1/e) + 1 steps.
// Bound: |t - t*| <= e where x(t) is exact; the error of y is that times |y'(t)|, and rounding.
// Fails: e is absolute, so that small y have few digits.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/easing/easing.hpp"

namespace bezierbench {

struct EasingItp : EasingAsGiven {
  static constexpr MethodInfo info{.id = "easing_itp",
                                   .label = "ITP in a bracket",
                                   .problem = Problem::easing,
                                   .min_degree = 3,
                                   .max_degree = 3,
                                   .flops = "20 per step",
                                   .citation = "[Oliveira and Takahashi 2021], algorithm 1"};

  template <class Scalar>
  static Eased<Scalar> solve(const EasingCurve<Scalar>& curve, Scalar x) {
    if (x == 0 || x == 1) return {x, x};
    constexpr Scalar e = std::numeric_limits<Scalar>::epsilon() / 2;
    Scalar a = 0;
    Scalar b = 1;
    Scalar at_a = -x;
    Scalar at_b = 1 - x;
    Scalar reach = 1;  // e 2^(n_half + n0 - j) in step j, with n_half = log2(1 / (2 e)) and n0 = 1
    int steps = 0;
    for (; b - a > 2 * e && steps < most_easing_steps; ++steps) {
      const Scalar middle = a + (b - a) / 2;
      const Scalar secant = (at_b * a - at_a * b) / (at_b - at_a);
      const Scalar shift = std::min(Scalar(0.2) * (b - a) * (b - a), std::abs(middle - secant));
      const Scalar moved = secant + std::copysign(shift, middle - secant);
      const Scalar slack = std::max(reach - (b - a) / 2, Scalar(0));
      const Scalar t = std::abs(moved - middle) <= slack ? moved : middle - std::copysign(slack, middle - moved);
      const Scalar value = bernstein_cubic(curve.x1, curve.x2, t) - x;
      if (value == 0) return {t, bernstein_cubic(curve.y1, curve.y2, t), steps + 1};
      (value > 0 ? b : a) = t;
      (value > 0 ? at_b : at_a) = value;
      reach /= 2;
    }
    const Scalar t = a + (b - a) / 2;
    return {t, bernstein_cubic(curve.y1, curve.y2, t), steps, steps < most_easing_steps};
  }
};

}  // namespace bezierbench
