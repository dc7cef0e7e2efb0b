// SPDX-License-Identifier: MIT
// Formula: with c_j the power coefficients, the roots t of c_1 + 2 c_2 t + 3 c_3 t^2 by q = -(b + sign(b) sqrt(b^2 - 4
//   a c)) / 2, t = q / a and c / q; p(t) by Horner's rule for each t in (0, 1). The ends are exact.
// Source: with `margin`, as in OpenJDK, each extremum counts as p(t) -+ ulp(|c_0| + |c_1| + |c_2| + |c_3|). A quadratic
//   follows accumulateExtremaBoundsForQuad.
// Bound: none is proved, although the margin is meant to cover the roundings.
// Fails: the box may be too small by the roundings of c_j, t and p(t); b^2 - 4 a c may overflow, underflow or cancel.
#pragma once

#include <cmath>

#include "core/bounds/bounds.hpp"

namespace bezierbench {

template <bool margin>
struct QuadraticFormulaBox {
  static constexpr BoxPromises promises{.contains = false, .within_one_ulp = false};
  static constexpr MethodInfo info{
      .id = margin ? "quadratic_formula_margin_box" : "quadratic_formula_box",
      .label = margin ? "Extrema by the quadratic formula, with OpenJDK's margin" : "Extrema by the quadratic formula",
      .problem = Problem::bounds,
      .max_degree = 3,
      .max_degree_float = 3,
      .flops = "30d",
      .citation = "[OpenJDK 2021], accumulateExtremaBoundsForCubic"};

  static Range range(const PolynomialAxis& axis) {
    const int n = axis.degree();
    Range range = range_of_ends(axis);
    if (n < 2) return range;
    double c[4] = {axis(0, 0), 0, 0, 0};
    const double first = n * (axis(0, 1) - axis(0, 0));
    if (n == 2) {
      c[1] = first;
      c[2] = (axis(0, 2) - axis(0, 1)) - (axis(0, 1) - axis(0, 0));
    } else {
      const double middle = 3 * (axis(0, 2) - axis(0, 1));
      c[3] = (axis(0, 3) - axis(0, 0)) - middle;
      c[2] = middle - first;
      c[1] = first;
    }
    const double size = std::abs(c[0]) + std::abs(c[1]) + std::abs(c[2]) + std::abs(c[3]);
    const double off = margin ? std::nextafter(size, whole_axis.high) - size : 0;
    const auto include = [&](double t) {
      if (!(t > 0 && t < 1)) return;
      const double p = c[0] + t * (c[1] + t * (c[2] + t * c[3]));
      range.include(p - off);
      range.include(p + off);
    };
    each_root(3 * c[3], 2 * c[2], c[1], include);
    return range;
  }

  /// The real roots of a t^2 + b t + c, and perhaps numbers that are not finite.
  template <class Take>
  static void each_root(double a, double b, double c, Take take) {
    if (a == 0) return take(-c / b);  // NaN or infinite where b is 0
    const double square = b * b - 4 * a * c;
    if (square < 0) return;
    const double q = (b + std::copysign(std::sqrt(square), b)) / -2;
    take(q / a);
    if (q != 0) take(c / q);
  }
};

}  // namespace bezierbench
