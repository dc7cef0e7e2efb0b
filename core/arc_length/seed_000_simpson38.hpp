// SPDX-License-Identifier: MIT
// Formula: Simpson's 3/8 rule S on a panel and on its halves, as the code of [Document 000] has it: where
//   |S_left + S_right - S| <= 15 eps it takes S_left + S_right + (S_left + S_right - S)/15, and elsewhere it halves the
//   panel and eps.
// Source: the document's `adaptive_simpson_3_8`, a baseline for adaptive_simpson38. Two things differ. eps, which the
//   document leaves to the caller, is the tolerance times the first S. Panels whose sums agree to 4 u, or which are
//   narrower than 2^-30, are not halved: there the document's recursion need not end.
// Cost: as printed; 3 speeds would do, since 4 of the 7 abscissae are those of the panel.
// Bound: none. The printed test holds the error below eps only where the fourth derivative of f hardly varies over the
//   panel, so this method states no estimate and `converged` is always false.
// Fails: the error exceeds the tolerance where the sums of the first panels agree by accident; the finding
//   arc_length_as_printed counts such cells. The curve with the control points 1, 18, 0, 19 on one axis turns back
//   between t = 17/36 and 1/2, between two abscissae: its length is 18 + 1/648, and every sum is 18.
#pragma once

#include <algorithm>
#include <cmath>

#include "core/arc_length/simpson38.hpp"

namespace bezierbench {

struct Seed000Simpson38 {
  static constexpr int depth_limit = 30;

  static constexpr MethodInfo info{.id = "seed_000_simpson38",
                                   .label = "Adaptive Simpson 3/8, as printed",
                                   .problem = Problem::arc_length,
                                   .form = Form::bernstein,
                                   .promise = "none: converged is no",
                                   .flops = "12 speeds of (n-1)(1+3d) + 2d + 2 per panel",
                                   .citation = "[Document 000], section 3.1"};

  template <int Dimension>
  static ArcLength measure(const Curve<Form::bernstein, double, Dimension>& hodograph, double tolerance) {
    Speed<Dimension> speed(hodograph);
    const double eps = tolerance * simpson38_panel(speed, 0, 1);
    ArcLength result;
    result.length = integral(speed, 0, 1, eps, 0);
    result.evaluations = speed.evaluations();
    return result;
  }

  /// The integral of f over [from, to], as printed.
  template <class Function>
  static double integral(Function& f, double from, double to, double eps, int depth) {
    constexpr double u = 0x1p-53;
    const double middle = (from + to) / 2.0;
    const double whole = simpson38_panel(f, from, to);
    const double left = simpson38_panel(f, from, middle);
    const double right = simpson38_panel(f, middle, to);
    const double difference = left + right - whole;
    if (std::abs(difference) <= std::max(15.0 * eps, 4 * u * whole) || depth == depth_limit)
      return left + right + difference / 15.0;
    return integral(f, from, middle, eps / 2.0, depth + 1) + integral(f, middle, to, eps / 2.0, depth + 1);
  }
};

}  // namespace bezierbench
