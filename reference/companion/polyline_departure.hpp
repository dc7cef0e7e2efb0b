// SPDX-License-Identifier: MIT
// How far a piecewise cubic leaves the polyline of the data that it is fitted to. The distance of the data from the
// curve, below, does not limit the curve between them.
#pragma once

#include <span>

#include "reference/rational.hpp"

namespace bezierbench::reference {

// The distance of data from a piecewise cubic: the largest, over the data points, of the least distance to any segment,
// from exact foot points.

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

struct Departure {
  double distance;    ///< in coordinate units
  double over_limit;  ///< above 1 where the curve is certainly beyond a limit
  double handle;      ///< the longest |b_1 - b_0| or |b_3 - b_2|, over the length of the polyline beside its segment
};

/// Passes the curve and the polyline from the first point to the last: `distance` is the largest distance of the part
/// of the curve between the places of two consecutive points from the line segment between these points, and of a place
/// from its point. So a curve is far away, too, that passes the points in another order. The true distance is not
/// smaller, and larger by at most 2^-17 of it; both up to 2^-46 of the largest difference of a control point and a data
/// point, by roundings.
///
/// `over_limit` is the largest quotient of that distance, less its roundings, and the limit of the step. With the
/// tolerance e and D_i = P_(i-1) - 2 P_i + P_(i+1) this is
///   5/2 e + min(max(|D_i|, |D_(i+1)|), 2 k, 2 max(k-, k+)) / 8 + 8u max|P|
/// for a step of length k between steps of lengths k- and k+. A cubic that visits the points at equal steps of its
/// parameter, each within e, keeps this limit where the minimum is the first of the three; core/fit/polyline.hpp
/// derives it. At a corner, where the data turn by more than 75.5 degrees (cosine 1/4), D is 0, and the step behind it
/// does not count. Closed data, whose last point equals the first, go on at their other end. Open data end: D is
/// extrapolated linearly from the next two, and there is no step beyond. Control points are doubles: the last term is
/// for their roundings, three in each of at most three coordinates of an inner one of a straight segment.
///
/// The step that leads to a point belongs to the segment of this point's place: `handle` compares a segment's handles
/// with the sum of the lengths of its steps.
///
/// `points`, `control_points` (four a segment) point by point, finite, in as many dimensions, at most 3; one place for
/// each point, the first and the last at the ends of the curve. Consecutive equal points count once, at the place of
/// the last.
Departure departure_from_polyline(int dimension, std::span<const double> points, std::span<const double> control_points,
                                  std::span<const NearPlace> places, double tolerance);

}  // namespace bezierbench::reference
