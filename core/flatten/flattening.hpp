// SPDX-License-Identifier: MIT
// The concept of a method for flattening: `info`, and a function from a curve and a tolerance to chords. The piece of
// the curve between the parameters of a chord's ends is promised, or hoped, to be within the tolerance of the chord.
#pragma once

#include <cmath>
#include <concepts>
#include <vector>

#include "core/curve.hpp"
#include "core/method.hpp"
#include "core/powers.hpp"

namespace bezierbench {

/// A method gives no more chords than this; where it would, `complete` is false.
inline constexpr int max_chords = 1 << 16;

/// A polyline: the end of a chord is the start of the next one.
struct Flattening {
  std::vector<double> t;       ///< parameters of the ends, from 0 to 1, each above the one before
  std::vector<double> points;  ///< their points, point by point
  int evaluations = 0;         ///< points, derivatives and subdivisions that the method computed
  bool complete = true;        ///< whether the method says that it kept the tolerance

  void clear() {
    t.clear();
    points.clear();
    evaluations = 0;
    complete = true;
  }
  template <class PointOf>
  void add(double parameter, const PointOf& point) {
    t.push_back(parameter);
    for (int axis = 0; axis < PointOf::SizeAtCompileTime; ++axis) points.push_back(point[axis]);
  }
};

/// `flatten(curve, tolerance, chords)` appends the ends of all chords to `chords`, which is empty; the first and the
/// last are the curve's. The tolerance is above 0.
template <class M>
concept FlattenMethod = requires(const Curve<M::info.form, double, 2>& curve, double tolerance, Flattening& chords) {
  requires M::info.problem == Problem::flattening;
  M::flatten(curve, tolerance, chords);
};

/// Control point i.
template <int Dimension, int Degree>
Point<double, Dimension> control_point(const Curve<Form::bernstein, double, Dimension, Degree>& curve, int i) {
  Point<double, Dimension> point;
  for (int axis = 0; axis < Dimension; ++axis) point[axis] = curve(axis, i);
  return point;
}

/// |a x b|^2; 0 on a line.
template <int Dimension>
double squared_cross_product(const Point<double, Dimension>& a, const Point<double, Dimension>& b) {
  double sum = 0;
  for (int i = 0; i < Dimension; ++i)
    for (int j = i + 1; j < Dimension; ++j) {
      const double minor = a[i] * b[j] - a[j] * b[i];
      sum += minor * minor;
    }
  return sum;
}

/// The square of the distance of a point from the segment between two others.
template <int Dimension>
double squared_distance_to_segment(const Point<double, Dimension>& point, const Point<double, Dimension>& from,
                                   const Point<double, Dimension>& to) {
  const Point<double, Dimension> chord = to - from;
  const Point<double, Dimension> offset = point - from;
  const double along = offset.dot(chord);
  const double squared_length = chord.squaredNorm();
  if (along <= 0 || squared_length == 0) return offset.squaredNorm();
  if (along >= squared_length) return (point - to).squaredNorm();
  return (offset - chord * (along / squared_length)).squaredNorm();
}

// The cube root by Newton's method, to a few ulp: no library decides its bits.

/// Of a finite x >= 0.
inline double cube_root(double x) {
  if (!(x > 0)) return 0;
  double root = std::ldexp(1, binary_exponent(x) / 3);  // within a factor of 2
  for (int k = 0; k < 7; ++k) root = (2 * root + x / (root * root)) / 3;
  return root;
}

}  // namespace bezierbench
