// SPDX-License-Identifier: MIT
// The concept of a method for piecewise fitting: `info` and two functions. `piece` makes a cubic segment near a section
// of the data. `tangent` gives the direction in which the curve passes a point, from the two chords at that point.
// Where a segment is too far from the data, piecewise.hpp splits the section.
#pragma once

#include <concepts>
#include <string_view>
#include <vector>

#include "core/fit/cubic.hpp"
#include "core/fit/kernel.hpp"
#include "core/fit/polyline.hpp"
#include "core/method.hpp"

namespace bezierbench {

/// The tangent at one end of a segment. The end itself is a data point.
template <int Dimension>
struct End {
  Point<double, Dimension> direction;  ///< unit vector into the section, from the data
  bool bound;  ///< whether the segment must leave in that direction, since it joins another smoothly
};

/// The data of one segment.
template <int Dimension>
struct Section {
  Polygon<Dimension> points;   ///< three or more, coordinates up to 1 in magnitude, consecutive ones different
  std::vector<double> t;       ///< parameter of each point, by the lengths of the chords, from 0 to 1
  double length;               ///< length of the polyline
  std::vector<double> limits;  ///< for each step of the polyline, how far from it the segment may be
  End<Dimension> start;
  End<Dimension> end;
  double tolerance;
};

/// The segment that a method fits to a section.
template <int Dimension>
struct Piece {
  Cubic<Dimension> cubic;  ///< from the first point to the last, finite
  std::vector<double> t;   ///< for each point, a parameter at which the segment is near it
  int iterations = 0;      ///< number of solutions for the handles
};

/// The largest distance of a point from the segment at the point's parameter, up to rounding.
template <int Dimension>
double largest_error(const Section<Dimension>& section, const Piece<Dimension>& piece) {
  double largest = 0;
  for (std::size_t i = 0; i < piece.t.size(); ++i) {
    const Point<double, Dimension> point = section.points.col(static_cast<Eigen::Index>(i));
    largest = std::max(largest, length<Dimension>(offset_at<Dimension>(piece.cubic, point, piece.t[i]).offset));
  }
  return largest;
}

/// Whether a segment keeps what a fit promises: it is within the tolerance of every point, and its parts between the
/// points are within their limits of the polyline, up to rounding.
template <int Dimension>
bool keeps_promise(const Section<Dimension>& section, const Piece<Dimension>& piece) {
  return largest_error(section, piece) <= section.tolerance &&
         !first_departure<Dimension>(section.points, section.limits, piece.cubic, piece.t);
}

/// No handle of a segment is longer than this many times the polyline of its points. No handle of any cubic is longer
/// than three times the cubic: the integral of C' is of degree 3, so that by Markov's inequality |C'| is at most 2 *
/// 3^2 times half the length, and |C'(0)| is 3 |b_1 - b_0|.
inline constexpr double longest_handle = 3;

/// What both methods promise, by way of piecewise.hpp.
inline constexpr std::string_view fit_promise =
    "no data point is farther from the curve than the tolerance; the curve stays near the polyline of the data";

template <class M>
concept FittingMethod = requires(const Section<2>& section, const Point<double, 2>& chord) {
  requires M::info.problem == Problem::fitting;
  { M::piece(section) } -> std::same_as<Piece<2>>;
  { M::template tangent<2>(chord, chord) } -> std::same_as<Point<double, 2>>;
};

}  // namespace bezierbench
