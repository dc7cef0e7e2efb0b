// SPDX-License-Identifier: MIT
// The methods for piecewise fitting behind function pointers.
#pragma once

#include <span>

#include "core/fit/result.hpp"
#include "core/method.hpp"

namespace bezierbench {

/// One method, for data with this many axes.
struct FittingKernel {
  const MethodInfo* info;
  int dimension;
  /// A piecewise cubic from the first data point to the last, whose distance to no data point exceeds `tolerance` >= 0
  /// (in coordinate units); `points` point by point, finite, one or more. Segments meet in data points, with the same
  /// tangent but at corners of the data and where the data turn back on themselves; so do the ends of closed data,
  /// whose last point is the first. Equal points in a row count once; one point alone gives one segment of equal
  /// control points. Scaling data and tolerance by a power of two scales the result. Cost: that of the method's `piece`
  /// times about the logarithm of the number of segments, at worst their number.
  Fit (*fit)(std::span<const double> points, double tolerance);
};

/// All methods, in roster order. Dimension is 1, 2 or 3.
std::span<const FittingKernel> fitting_kernels(int dimension);

/// The data of all methods, in roster order.
std::span<const MethodInfo* const> fitting_infos();

}  // namespace bezierbench
