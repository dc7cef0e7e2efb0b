// SPDX-License-Identifier: MIT
// Control polygons as the projectors cut and evaluate them: one column a point, as many as there are.
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <utility>

#include "core/curve.hpp"

namespace bezierbench {

/// Not of bounded size, unlike a Curve: the projectors keep many, of low degree.
template <int Dimension>
using Polygon = Eigen::Matrix<double, Dimension, Eigen::Dynamic, Dimension == 1 ? Eigen::RowMajor : Eigen::ColMajor>;

template <int Dimension>
int degree_of(const Polygon<Dimension>& b) {
  return static_cast<int>(b.cols()) - 1;
}

/// a.b, summed from the first axis on.
template <int Dimension>
double dot(const Point<double, Dimension>& a, const Point<double, Dimension>& b) {
  double sum = a[0] * b[0];
  for (int axis = 1; axis < Dimension; ++axis) sum += a[axis] * b[axis];
  return sum;
}

/// |v|, scaled by a power of two before it is squared.
template <int Dimension>
double length(const Point<double, Dimension>& v) {
  double largest = 0;
  for (int axis = 0; axis < Dimension; ++axis) largest = std::max(largest, std::abs(v[axis]));
  if (largest == 0 || !std::isfinite(largest)) return largest;
  int exponent = 0;
  std::frexp(largest, &exponent);
  Point<double, Dimension> scaled;
  for (int axis = 0; axis < Dimension; ++axis) scaled[axis] = std::ldexp(v[axis], -exponent);
  return std::ldexp(std::sqrt(dot<Dimension>(scaled, scaled)), exponent);
}

/// The largest magnitude of a coordinate.
template <int Dimension>
double largest_coordinate(const Polygon<Dimension>& b) {
  double largest = 0;
  for (int i = 0; i <= degree_of<Dimension>(b); ++i)
    for (int axis = 0; axis < Dimension; ++axis) largest = std::max(largest, std::abs(b(axis, i)));
  return largest;
}

/// The point at t by de Casteljau; the zero vector for no points.
template <int Dimension>
Point<double, Dimension> point_at(Polygon<Dimension> b, double t) {
  if (b.cols() == 0) return Point<double, Dimension>::Zero();
  const double s = 1 - t;
  for (int last = degree_of<Dimension>(b); last > 0; --last)
    for (int i = 0; i < last; ++i)
      for (int axis = 0; axis < Dimension; ++axis) b(axis, i) = s * b(axis, i) + t * b(axis, i + 1);
  return b.col(0);
}

/// b_(i+1) - b_i.
template <int Dimension>
Polygon<Dimension> differences(const Polygon<Dimension>& b) {
  Polygon<Dimension> result(Dimension, std::max<Eigen::Index>(b.cols() - 1, 0));
  for (Eigen::Index i = 0; i < result.cols(); ++i)
    for (int axis = 0; axis < Dimension; ++axis) result(axis, i) = b(axis, i + 1) - b(axis, i);
  return result;
}

/// The polygons over [0, 1/2] and [1/2, 1]. Each coordinate has passed at most `degree` roundings of at most
/// u largest_coordinate(b).
template <int Dimension>
std::pair<Polygon<Dimension>, Polygon<Dimension>> halves(Polygon<Dimension> b) {
  const int n = degree_of<Dimension>(b);
  Polygon<Dimension> left(Dimension, n + 1);
  for (int k = 0; k <= n; ++k) {
    left.col(k) = b.col(0);
    for (int i = 0; i < n - k; ++i)
      for (int axis = 0; axis < Dimension; ++axis) b(axis, i) = (b(axis, i) + b(axis, i + 1)) / 2;
  }
  return {std::move(left), std::move(b)};  // what was not overwritten on level k is the last point of that level
}

}  // namespace bezierbench
