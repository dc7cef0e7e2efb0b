// SPDX-License-Identifier: MIT
// The result of a method for piecewise fitting.
#pragma once

#include <vector>

namespace bezierbench {

/// A piecewise cubic near the data.
struct Fit {
  std::vector<double> control_points;  ///< segment by segment, four points each, point by point
  std::vector<int> segment;            ///< of each data point, that where it was compared with the curve
  std::vector<double> t;               ///< of each data point, in that segment
  double max_error = 0;   ///< no data point is farther from the curve, in coordinate units, rounding included
  int iterations = 0;     ///< of all sections that were tried
  bool converged = true;  ///< max_error is at most the tolerance; false only where control points overflow

  [[nodiscard]] int segments(int dimension) const { return static_cast<int>(control_points.size()) / (4 * dimension); }
};

}  // namespace bezierbench
