// SPDX-License-Identifier: MIT
// A knot span of a B-spline curve behind the erased interfaces.
#pragma once

#include <span>

namespace bezierbench {

/// A curve of degree m >= 1 in one knot span, as core/bspline/bspline.hpp describes it. Knots and control points
/// stay in the caller's memory.
struct BsplineSpanView {
  int dimension = 2;
  int degree = 1;
  std::span<const double> knots;           ///< 2m
  std::span<const double> control_points;  ///< (m + 1) * dimension coordinates, point by point
};

}  // namespace bezierbench
