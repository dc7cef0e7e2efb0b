// SPDX-License-Identifier: MIT
// The result of a method for piecewise fitting.
#pragma once

#include <span>
#include <vector>

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

}  // namespace bezierbench
