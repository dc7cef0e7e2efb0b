// SPDX-License-Identifier: MIT
// Formula: of a conic p = N / W, N'W - NW' has the Bernstein coefficients 2 w_0 w_1 (b_1 - b_0), w_0 w_2 (b_2 - b_0)
//   and 2 w_1 w_2 (b_2 - b_1) of degree 2: extrema by the quadratic formula, then p(t) for each t in (0, 1).
// Source: derived here, from the quotient rule.
// Cost: a square root and two divisions an axis are among the flops.
// Bound: none.
// Fails: the box may be too small by the roundings of t and p(t); the discriminant may cancel, and products of weights
//   may leave the range.
#pragma once

#include "core/bounds/quadratic_formula_box.hpp"

namespace bezierbench {

struct ConicBox {
  static constexpr BoxPromises promises{.contains = false, .within_one_ulp = false};
  static constexpr MethodInfo info{.id = QuadraticFormulaBox<false>::info.id,
                                   .label = QuadraticFormulaBox<false>::info.label,
                                   .problem = Problem::bounds,
                                   .form = Form::rational,
                                   .max_degree = 2,
                                   .max_degree_float = 2,
                                   .flops = "40d",
                                   .citation = "[Piegl and Tiller 1997], eq. (4.8)"};

  static Range range(const RationalAxis& axis) {
    if (!stays_in_hull(axis)) return whole_axis;
    Range range = range_of_ends(axis);
    if (axis.degree() < 2) return range;
    const auto& b = axis.points;
    const auto& w = axis.weights;
    const double u0 = 2 * w[0] * w[1] * (b(0, 1) - b(0, 0));
    const double u1 = w[0] * w[2] * (b(0, 2) - b(0, 0));
    const double u2 = 2 * w[1] * w[2] * (b(0, 2) - b(0, 1));
    QuadraticFormulaBox<false>::each_root((u2 - u1) - (u1 - u0), 2 * (u1 - u0), u0, [&](double t) {
      if (!(t > 0 && t < 1)) return;
      const double s = 1 - t;
      const double f0 = w[0] * s * s;
      const double f1 = 2 * w[1] * s * t;
      const double f2 = w[2] * t * t;
      range.include((f0 * b(0, 0) + f1 * b(0, 1) + f2 * b(0, 2)) / (f0 + f1 + f2));
    });
    return range;
  }
};

}  // namespace bezierbench
