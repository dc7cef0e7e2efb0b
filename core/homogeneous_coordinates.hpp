// SPDX-License-Identifier: MIT
// A rational curve of d axes as a polynomial one of d + 1, (w_i b_i, w_i), and the points of that over the last axis.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/curve.hpp"

namespace bezierbench {

template <class Scalar, int Dimension, int Degree>
Curve<Form::bernstein, Scalar, Dimension + 1, Degree> homogeneous(
    const Curve<Form::rational, Scalar, Dimension, Degree>& curve) {
  Curve<Form::bernstein, Scalar, Dimension + 1, Degree> result(curve.degree());
  for (int i = 0; i <= curve.degree(); ++i) {
    for (int axis = 0; axis < Dimension; ++axis) result(axis, i) = curve.weights[i] * curve.points(axis, i);
    result(Dimension, i) = curve.weights[i];
  }
  return result;
}

/// Not finite where a weight is 0.
template <class Scalar, int Axes, int Degree>
Curve<Form::rational, Scalar, Axes - 1, Degree> over_last_axis(
    const Curve<Form::bernstein, Scalar, Axes, Degree>& curve) {
  Curve<Form::rational, Scalar, Axes - 1, Degree> result(curve.degree());
  for (int i = 0; i <= curve.degree(); ++i) {
    result.weights[i] = curve(Axes - 1, i);
    for (int axis = 0; axis < Axes - 1; ++axis) result.points(axis, i) = curve(axis, i) / result.weights[i];
  }
  return result;
}

/// Whether no weight is 0 or of another sign, so that the curve lies in the hull of its control points.
template <class Scalar, int Dimension, int Degree>
bool weights_have_one_sign(const Curve<Form::rational, Scalar, Dimension, Degree>& curve) {
  const auto [least, largest] = std::minmax_element(curve.weights.begin(), curve.weights.end());
  return *least > 0 || *largest < 0;
}

/// Whether weights other than 0 are so near to each other that products with coordinates of the scaled ones lose no
/// digits.
template <int Dimension, int Degree>
bool weights_are_in_range(const Curve<Form::rational, double, Dimension, Degree>& curve) {
  constexpr double widest = 0x1p900;
  double least = std::numeric_limits<double>::infinity();
  double largest = 0;
  for (int i = 0; i <= curve.degree(); ++i) {
    const double size = std::abs(curve.weights[i]);
    largest = std::max(largest, size);
    if (size > 0) least = std::min(least, size);
  }
  return largest / widest <= least;
}

}  // namespace bezierbench
