// SPDX-License-Identifier: MIT
// Control polygons in the form in which the projectors halve and evaluate them: one column per point.
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <utility>

#include "core/curve.hpp"
#include "core/evaluate/kernel/points/axes.hpp"
#include "core/powers.hpp"

namespace bezierbench {

// Loops of a length known at compile time, unrolled step by step: GCC unrolls nested loops too late to keep small
// polygons in registers.

/// Calls step(i) for i = 0, ..., count - 1. Count is that number at compile time, or `dynamic`.
template <int Count, class Step>
void each(int count, const Step& step) {
  if constexpr (Count == dynamic)
    for (int i = 0; i < count; ++i) step(i);
  else
    [&]<int... I>(std::integer_sequence<int, I...> /*all*/) { (step(I), ...); }
  (std::make_integer_sequence<int, Count>());
}

/// For every level of de Casteljau's triangle with at least `Least` points calls step(i) for i = 0, ..., count - 1,
/// where count falls from the degree to `Least`. Degree is that number at compile time, or `dynamic`.
template <int Degree, int Least = 1, class Step>
void each_of_triangle(int degree, const Step& step) {
  if constexpr (Degree == dynamic)
    for (int count = degree; count >= Least; --count) each<dynamic>(count, step);
  else if constexpr (Degree >= Least) {
    each<Degree>(Degree, step);
    each_of_triangle<Degree - 1, Least>(Degree - 1, step);
  }
}

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

/// All coordinates of point i in one vector. Without it the compiler builds vectors of coordinates of several points,
/// element by element.
template <int Dimension, int Points>
Axes<double, Dimension> column(const Polygon<Dimension, Points>& b, Eigen::Index i) {
  return Axes<double, Dimension>::read(b.data() + Dimension * i);
}
template <int Dimension, int Points>
void set_column(Polygon<Dimension, Points>& b, Eigen::Index i, const Axes<double, Dimension>& coordinates) {
  coordinates.store(b.data() + Dimension * i);
}

/// a.b, summed up from the first axis on.
template <int Dimension>
double dot(const Point<double, Dimension>& a, const Point<double, Dimension>& b) {
  double sum = a[0] * b[0];
  for (int axis = 1; axis < Dimension; ++axis) sum += a[axis] * b[axis];
  return sum;
}

/// The largest magnitude of `count` numbers, 0 for none. Count is that number at compile time, or `dynamic`.
template <int Count>
[[gnu::always_inline]] inline double largest_magnitude(const double* values, int count) {
  if constexpr (Count == dynamic) {
    double largest = 0;
    for (int i = 0; i < count; ++i) largest = std::max(largest, std::abs(values[i]));
    return largest;
  } else if constexpr (Count < 2) {
    return Count == 0 ? 0 : std::abs(values[0]);
  } else {  // by halves, whose maxima do not wait for each other
    constexpr int half = Count / 2;
    return std::max(largest_magnitude<half>(values, half),
                    largest_magnitude<Count - half>(values + half, Count - half));
  }
}

/// The largest magnitude of a coordinate.
template <int Dimension>
double largest_coordinate(const Point<double, Dimension>& v) {
  return largest_magnitude<Dimension>(v.data(), Dimension);
}

/// |v| by way of a power of two that v is divided by, whose largest coordinate is known.
template <int Dimension>
[[gnu::noinline]] double length_of_scaled(const Point<double, Dimension>& v, double largest) {
  if (largest == 0 || !std::isfinite(largest)) return largest;
  const int exponent = binary_exponent(largest);
  Point<double, Dimension> scaled;
  for (int axis = 0; axis < Dimension; ++axis) scaled[axis] = std::ldexp(v[axis], -exponent);
  return std::ldexp(std::sqrt(dot<Dimension>(scaled, scaled)), exponent);
}

/// |v|. Where squares would overflow or underflow, v is scaled first.
template <int Dimension>
double length(const Point<double, Dimension>& v) {
  const double largest = largest_coordinate<Dimension>(v);
  if (largest >= 0x1p-480 && largest <= 0x1p+510) return std::sqrt(dot<Dimension>(v, v));  // the bits are the same
  return length_of_scaled<Dimension>(v, largest);
}

/// The largest magnitude of a coordinate.
template <int Dimension, int Points>
double largest_coordinate(const Polygon<Dimension, Points>& b) {
  constexpr int coordinates = Points == dynamic ? dynamic : Dimension * Points;
  return largest_magnitude<coordinates>(b.data(), static_cast<int>(b.size()));
}

/// The point at t by de Casteljau; the zero vector for no points.
template <int Dimension, int Points>
Point<double, Dimension> point_at(Polygon<Dimension, Points> b, double t) {
  if (b.cols() == 0) return Point<double, Dimension>::Zero();
  const Axes<double, Dimension> s(1 - t);
  const Axes<double, Dimension> next_weight(t);
  each_of_triangle<count_of(Points, -1)>(degree_of<Dimension>(b), [&](int i) {
    set_column<Dimension>(b, i, s * column<Dimension>(b, i) + next_weight * column<Dimension>(b, i + 1));
  });
  return b.col(0);
}

/// b_(i+1) - b_i.
template <int Dimension, int Points>
Polygon<Dimension, count_of(Points, -1)> differences(const Polygon<Dimension, Points>& b) {
  Polygon<Dimension, count_of(Points, -1)> result;
  result.resize(Dimension, std::max<Eigen::Index>(b.cols() - 1, 0));
  for (Eigen::Index i = 0; i < result.cols(); ++i)
    set_column<Dimension>(result, i, column<Dimension>(b, i + 1) - column<Dimension>(b, i));
  return result;
}

/// Sets the polygons over [0, 1/2] and [1/2, 1]. Each coordinate has at most `degree` roundings, of at most u
/// largest_coordinate(b) each.
template <int Dimension, int Points>
void halve(const Polygon<Dimension, Points>& b, Polygon<Dimension, Points>& left, Polygon<Dimension, Points>& right) {
  auto last = b;   // column n - k will be the last point of level k
  auto first = b;  // column k the first one
  int level = 0;
  const Axes<double, Dimension> half(0.5);
  each_of_triangle<count_of(Points, -1)>(degree_of<Dimension>(b), [&](int i) {
    const auto middle = (column<Dimension>(last, i) + column<Dimension>(last, i + 1)) * half;
    set_column<Dimension>(last, i, middle);
    if (i == 0) set_column<Dimension>(first, ++level, middle);
  });
  left = std::move(first);
  right = std::move(last);
}

}  // namespace bezierbench
