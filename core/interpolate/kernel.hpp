// SPDX-License-Identifier: MIT
// The methods for interpolation behind function pointers.
#pragma once

#include <span>
#include <vector>

#include "core/interpolate/interpolation.hpp"
#include "core/method.hpp"

namespace bezierbench {

/// One method, for points of any dimension.
struct InterpolationKernel {
  const MethodInfo* info;
  double residual_bound;  ///< in u times the largest coordinate of an axis, beside residual_underflow; 0: none
  /// The n cubic Bezier segments through n + 1 >= 2 points of `dimension` finite coordinates each, point by point: 4 n
  /// control points, segment by segment. The first and last control point of a segment are the given points, bit for
  /// bit. Each axis is scaled by a power of two first, so that the results scale with the coordinates. An inner control
  /// point beyond the largest double is infinite.
  std::vector<double> (*interpolate)(std::span<const double> points, int dimension);
};

/// All methods, in roster order.
std::span<const InterpolationKernel> interpolation_kernels();

}  // namespace bezierbench
