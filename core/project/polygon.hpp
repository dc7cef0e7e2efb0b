// SPDX-License-Identifier: MIT
// Control polygons in the form in which the projectors halve and evaluate them: one column per point.
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <utility>

#include "core/curve.hpp"
#include "core/project/written_out.hpp"

namespace bezierbench {

/// `Points` columns, or a dynamic number. Unlike a Curve, a polygon has no room for the largest degree, since the
/// projectors keep many polygons of low degree.
template <int Dimension, int Points = dynamic>
using Polygon = Eigen::Matrix<double, Dimension, Points, Dimension == 1 ? Eigen::RowMajor : Eigen::ColMajor>;

/// `points + more`; dynamic where either is.
constexpr int count_of(int points, int more) { return points == dynamic ? dynamic : points + more; }

template <int Dimension, int Points>
int degree_of(const Polygon<Dimension, Points>& b) {
  return static_cast<int>(b.cols()) - 1;
}

/// a.b, summed up from the first axis on.
template <int Dimension>
double dot(const Point<double, Dimension>& a, const Point<double, Dimension>& b) {
  double sum = a[0] * b[0];
  for (int axis = 1; axis < Dimension; ++axis) sum += a[axis] * b[axis];
  return sum;
}

/// |v|. Where squares would overflow or underflow, v is scaled by a power of two first.
template <int Dimension>
double length(const Point<double, Dimension>& v) {
  double largest = 0;
  for (int axis = 0; axis < Dimension; ++axis) largest = std::max(largest, std::abs(v[axis]));
  if (largest >= 0x1p-480 && largest <= 0x1p+510)
    return std::sqrt(dot<Dimension>(v, v));  // same bits as the code below
  if (largest == 0 || !std::isfinite(largest)) return largest;
  int exponent = 0;
  std::frexp(largest, &exponent);
  Point<double, Dimension> scaled;
  for (int axis = 0; axis < Dimension; ++axis) scaled[axis] = std::ldexp(v[axis], -exponent);
  return std::ldexp(std::sqrt(dot<Dimension>(scaled, scaled)), exponent);
}

/// The largest magnitude of a coordinate.
template <int Dimension, int Points>
double largest_coordinate(const Polygon<Dimension, Points>& b) {
  double largest = 0;
  for (int i = 0; i <= degree_of<Dimension>(b); ++i)
    for (int axis = 0; axis < Dimension; ++axis) largest = std::max(largest, std::abs(b(axis, i)));
  return largest;
}

/// The point at t by de Casteljau; the zero vector for no points.
template <int Dimension, int Points>
Point<double, Dimension> point_at(Polygon<Dimension, Points> b, double t) {
  if (b.cols() == 0) return Point<double, Dimension>::Zero();
  const double s = 1 - t;
  each_of_triangle<count_of(Points, -1)>(degree_of<Dimension>(b), [&](int i) {
    for (int axis = 0; axis < Dimension; ++axis) b(axis, i) = s * b(axis, i) + t * b(axis, i + 1);
  });
  return b.col(0);
}

/// b_(i+1) - b_i.
template <int Dimension, int Points>
Polygon<Dimension, count_of(Points, -1)> differences(const Polygon<Dimension, Points>& b) {
  Polygon<Dimension, count_of(Points, -1)> result;
  result.resize(Dimension, std::max<Eigen::Index>(b.cols() - 1, 0));
  for (Eigen::Index i = 0; i < result.cols(); ++i)
    for (int axis = 0; axis < Dimension; ++axis) result(axis, i) = b(axis, i + 1) - b(axis, i);
  return result;
}

/// The polygons over [0, 1/2] and [1/2, 1]. Each coordinate has at most `degree` roundings, of at most u
/// largest_coordinate(b) each.
template <int Dimension, int Points>
std::pair<Polygon<Dimension, Points>, Polygon<Dimension, Points>> halves(Polygon<Dimension, Points> b) {
  const int n = degree_of<Dimension>(b);
  Polygon<Dimension, Points> left;
  left.resize(Dimension, n + 1);
  left.col(0) = b.col(0);
  int level = 0;
  each_of_triangle<count_of(Points, -1)>(n, [&](int i) {
    for (int axis = 0; axis < Dimension; ++axis) b(axis, i) = (b(axis, i) + b(axis, i + 1)) / 2;
    if (i == 0) left.col(++level) = b.col(0);
  });
  return {std::move(left), std::move(b)};  // column n - k of b keeps the last point of level k
}

}  // namespace bezierbench
