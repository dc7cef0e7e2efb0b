// SPDX-License-Identifier: MIT
// A proved error bound of a point of a B-spline curve as data, like ErrorBound of a point of a Bezier curve, and of the
// control points of a knot span in Bernstein form. docs/proofs/homogeneous.md derives what it becomes with weights.
#pragma once

#include <optional>
#include <string_view>

#include "core/bound/error_bound.hpp"

namespace bezierbench {

/// With p~ = sum |d_i| N_i(t) over the control points of the B-spline curve of degree n, on each axis, for t in the
/// span,
///   |computed - true| <= factor(n, u) u p~ + underflow(n) eta (1 + max|d|)
/// of `point`, where eta is the smallest subnormal. A control point of the span in Bernstein form is the blossom of the
/// curve at ends of the span, sum d_i c_i with c_i >= 0, and has the same bound by `control`, with p~ = sum |d_i| c_i.
/// Every result is a convex combination of control points, so that nothing overflows while max|d| stays in range
/// (`stays_in_range`).
struct BsplineBound {
  struct Part {
    double (*factor)(int degree, double u);
    double (*underflow)(int degree);
  };

  std::string_view text;  ///< for people
  Part point;
  std::optional<Part> control = std::nullopt;  ///< where the method makes the Bernstein form
};

}  // namespace bezierbench
