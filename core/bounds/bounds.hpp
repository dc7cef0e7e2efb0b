// SPDX-License-Identifier: MIT
// The concept of a method for the box of a curve: `info`, `promises`, and one function from the coordinates of one axis
// to their range. A box is the range of each axis.
#pragma once

#include <concepts>
#include <limits>

#include "core/curve.hpp"
#include "core/method.hpp"

namespace bezierbench {

/// The lowest and the highest coordinate of a box on one axis.
struct Range {
  double low;
  double high;

  /// Extends the range to x.
  void include(double x) {
    low = x < low ? x : low;
    high = x > high ? x : high;
  }
};

/// What is proved of a method, for all finite control points; for rational curves with weights of one sign.
struct BoxPromises {
  bool contains;        ///< no point with t in [0, 1] is outside the box
  bool within_one_ulp;  ///< on each side at most one double lies between the side and the tightest one
};

/// `range(axis)` returns the range of the curve's coordinate on one axis. It is pure, and neither prints nor throws.
template <class M>
concept BoundsMethod = requires(const Curve<M::info.form, double, 1>& axis) {
  requires M::info.problem == Problem::bounds;
  { M::promises } -> std::convertible_to<BoxPromises>;
  { M::range(axis) } -> std::same_as<Range>;
};

using PolynomialAxis = Curve<Form::bernstein, double, 1>;
using RationalAxis = Curve<Form::rational, double, 1>;

inline const PolynomialAxis& control_points(const PolynomialAxis& axis) { return axis; }
inline const PolynomialAxis& control_points(const RationalAxis& axis) { return axis.points; }

/// Whether the curve stays in the hull of its control points.
inline bool stays_in_hull(const PolynomialAxis& /*axis*/) { return true; }
inline bool stays_in_hull(const RationalAxis& axis) {
  return axis.weights.minCoeff() >= 0 || axis.weights.maxCoeff() <= 0;
}

/// The range of a curve that may be anywhere.
inline constexpr Range whole_axis{-std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()};

/// The range of the end points.
template <class Axis>
Range range_of_ends(const Axis& axis) {
  const auto& b = control_points(axis);
  Range range{b(0, 0), b(0, 0)};
  range.include(b(0, axis.degree()));
  return range;
}

/// The range of the control points.
template <class Axis>
Range range_of_control_points(const Axis& axis) {
  if (!stays_in_hull(axis)) return whole_axis;
  Range range = range_of_ends(axis);
  for (int i = 1; i < axis.degree(); ++i) range.include(control_points(axis)(0, i));
  return range;
}

}  // namespace bezierbench
