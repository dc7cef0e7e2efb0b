// SPDX-License-Identifier: MIT
// The distance of data from a piecewise cubic: the largest, over the data points, of the least distance to any segment,
// from exact foot points.
#pragma once

#include <span>

#include "reference/rational.hpp"

namespace bezierbench::reference {

/// A place on a piecewise curve that a method claims to be near a point. It affects the time of the search only.
struct NearPlace {
  int segment;  ///< from 0
  double t;     ///< in [0, 1]
};

/// The square of the distance of the data from the piecewise curve. `points` and `control_points` (four a segment)
/// point by point, finite, in as many dimensions, at most 3; one place for each point. The root has an error of at most
/// 2^-126 times the length of a segment.
Rational largest_squared_distance(int dimension, std::span<const double> points, std::span<const double> control_points,
                                  std::span<const NearPlace> places);

}  // namespace bezierbench::reference
