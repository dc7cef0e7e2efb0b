// SPDX-License-Identifier: MIT
// Formula: Simpson's 3/8 rule on the whole curve, S = (f(0) + 3 f(1/3) + 3 f(2/3) + f(1)) / 8 with the speed f = |C'|.
// Bound: none, and no estimate, whatever the tolerance; so `converged` is always false. The error is at most F/6480,
//   where F bounds the fourth derivative of f ([Davis and Rabinowitz 1984], section 2.2).
// Fails: wherever the speed is not nearly a cubic. The numbers 0, 2, -1, which turn back at t = 2/5, give 5/2, and
//   their length is 13/5. The parabola (0,0) (1/2,0) (1,1) gives (6 + sqrt(13) + sqrt(5))/8 = 1.4802, and its length is
//   sqrt(5)/2 + asinh(2)/4 = 1.4789.
#pragma once

#include "core/arc_length/arc_length.hpp"
#include "core/arc_length/speed.hpp"

namespace bezierbench {

/// Eq. (13) over [from, to], in the order of its terms as printed.
template <class Function>
double simpson38_panel(Function&& f, double from, double to) {
  const double first = (2 * from + to) / 3.0;
  const double second = (from + 2 * to) / 3.0;
  const double at_from = f(from);
  const double at_first = f(first);
  const double at_second = f(second);
  return (at_from + 3.0 * at_first + 3.0 * at_second + f(to)) * (to - from) / 8.0;
}

struct Simpson38 {
  static constexpr MethodInfo info{.id = "simpson38",
                                   .label = "Simpson 3/8, one panel",
                                   .problem = Problem::arc_length,
                                   .form = Form::bernstein,
                                   .promise = "none: converged is no",
                                   .flops = "4 speeds of (n-1)(1+3d) + 2d + 2",
                                   .citation = "[Document 000], eq. (13)"};

  template <class Hodograph>
  static ArcLength measure(const Hodograph& hodograph, double /*tolerance*/) {
    auto speed = speed_of(hodograph);
    ArcLength result;
    result.length = simpson38_panel(speed, 0, 1);
    result.evaluations = speed.evaluations();
    return result;
  }
};

}  // namespace bezierbench
