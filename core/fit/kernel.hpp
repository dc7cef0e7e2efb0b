// SPDX-License-Identifier: MIT
// The methods for piecewise fitting behind function pointers.
#pragma once

#include <span>
#include <vector>

#include "core/method.hpp"

namespace bezierbench {

/// Directions in which a fit begins and ends, along the curve: vectors of any length but 0, with as many coordinates as
/// the data; empty where the data decide.
struct FitEnds {
  std::span<const double> start{};
  std::span<const double> end{};
};

/// A piecewise cubic near the data.
struct Fit {
  std::vector<double> control_points;  ///< segment by segment, four points each, point by point
  std::vector<int> segment;            ///< for each data point, the segment with which it was compared
  std::vector<double> t;               ///< for each data point, its parameter in that segment
  double max_error = 0;   ///< bound of the distance of every data point, in coordinate units, roundings included
  int iterations = 0;     ///< sum over all sections that were tried
  bool converged = true;  ///< whether max_error is at most the tolerance; false only where control points overflow

  [[nodiscard]] int segments(int dimension) const { return static_cast<int>(control_points.size()) / (4 * dimension); }
};

/// One method, for data of one dimension.
struct FittingKernel {
  const MethodInfo* info;
  int dimension;
  /// A piecewise cubic from the first data point to the last, with a distance of at most `tolerance` >= 0 (in
  /// coordinate units) from every data point. Between two points it is within the limit of polyline.hpp of the line
  /// segment between them, and no handle is longer than three times the polyline beside it. `points` has one or more
  /// finite points, point by point. Segments meet in data points. They have the same tangent there, except at corners
  /// of the data, where the data turn back, and where the limit is too small for it; the same holds for the ends of
  /// closed data, whose last point equals the first. The curve begins and ends in the directions of `ends`, where these
  /// are given; there closed data may have a corner. Consecutive equal points count once; a single point gives one
  /// segment of equal control points. Scaling data and tolerance by a power of two scales the result. Cost: the cost of
  /// the method's `piece`, times about the logarithm of the number of segments and at most their number.
  Fit (*fit)(std::span<const double> points, double tolerance, const FitEnds& ends);
};

/// All methods, in roster order. Dimension is 1, 2 or 3.
std::span<const FittingKernel> fitting_kernels(int dimension);

}  // namespace bezierbench
