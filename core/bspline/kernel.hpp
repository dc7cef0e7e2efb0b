// SPDX-License-Identifier: MIT
// The methods for B-spline curves behind function pointers.
#pragma once

#include <span>

#include "core/bound/bspline_bound.hpp"
#include "core/bspline_curve.hpp"
#include "core/method.hpp"

namespace bezierbench {

/// One method, for curves of one dimension.
struct BsplineKernel {
  const MethodInfo* info;
  const BsplineBound* bound;  ///< of polynomial curves; nullptr where nothing is proved
  int dimension;
  bool makes_bernstein;  ///< whether it makes the Bernstein form of the span
  /// Writes the coordinates of the point at t in the span and, where it makes the Bernstein form, behind them those of
  /// its degree + 1 control points, point by point, and then the weights of a rational curve. The knots are those of
  /// `are_span_knots`.
  void (*solve)(const BsplineSpanView& span, double t, double* coordinates);
};

/// The number of points that `solve` writes.
inline int points_solved(const BsplineKernel& kernel, int degree) {
  return 1 + (kernel.makes_bernstein ? degree + 1 : 0);
}

/// The number of numbers that it writes.
inline int numbers_solved(const BsplineKernel& kernel, const BsplineSpanView& span) {
  const int points = points_solved(kernel, span.degree);
  return points * span.dimension + (span.weights.empty() ? 0 : points - 1);
}

/// All methods, in roster order. Dimension is 1, 2 or 3.
std::span<const BsplineKernel> bspline_kernels(int dimension);

}  // namespace bezierbench
