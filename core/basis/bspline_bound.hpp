// SPDX-License-Identifier: MIT
// A proved error bound of a point of a B-spline curve as data, like ErrorBound of a point of a Bezier curve, and of the
// control points of a knot span in Bernstein form.
#pragma once

#include <string_view>

#include "core/basis/error_bound.hpp"

namespace bezierbench {

/// With p~ = sum |d_i| N_i(t) over the control points of the B-spline curve of degree n, on each axis, for t in the
/// span,
///   |computed - true| <= point(n, u) u p~ + underflow(n) eta (1 + max|d|),
/// where eta is the smallest subnormal. A control point of the span in Bernstein form is the blossom of the curve at
/// ends of the span, sum d_i c_i with c_i >= 0, and has the same bound with `control` for `point` and p~ = sum |d_i|
/// c_i. Holds while nothing overflows.
struct BsplineBound {
  std::string_view text;  ///< for people
  double (*point)(int degree, double u);
  double (*control)(int degree, double u);  ///< nullptr where the method makes no Bernstein form
  double (*underflow)(int degree);
};

}  // namespace bezierbench
