// SPDX-License-Identifier: MIT
// Bounds of the length of a panel from the control vectors of its hodograph, and the halving of panels.
#pragma once

#include <algorithm>
#include <cmath>

#include "core/curve.hpp"

namespace bezierbench {

/// The length of the chord, |mean of the control vectors|, which is a lower bound of the length of the panel.
template <int Dimension, int Degree>
double chord_length(const Curve<Form::bernstein, double, Dimension, Degree>& h) {
  double square = 0;
  for (int axis = 0; axis < Dimension; ++axis) {
    double sum = 0;
    for (int i = 0; i <= h.degree(); ++i) sum += h(axis, i);
    square += sum * sum;
  }
  return std::sqrt(square) / (h.degree() + 1);
}

/// The size of the longest of the control vectors 0, ..., last.
template <int Dimension, int Degree>
double longest_vector(const Curve<Form::bernstein, double, Dimension, Degree>& h, int last) {
  double largest_square = 0;
  for (int i = 0; i <= last; ++i) {
    double square = 0;
    for (int axis = 0; axis < Dimension; ++axis) square += h(axis, i) * h(axis, i);
    largest_square = std::max(largest_square, square);
  }
  return std::sqrt(largest_square);
}

/// The size of the longest control vector.
template <int Dimension, int Degree>
double longest_vector(const Curve<Form::bernstein, double, Dimension, Degree>& h) {
  return longest_vector(h, h.degree());
}

/// Halves a hodograph: returns the left half and leaves the right one in h.
template <int Dimension, int Degree>
Curve<Form::bernstein, double, Dimension, Degree> cut_left_half(Curve<Form::bernstein, double, Dimension, Degree>& h) {
  const int m = h.degree();
  Curve<Form::bernstein, double, Dimension, Degree> left(m);
  for (int level = 0; level <= m; ++level) {
    for (int axis = 0; axis < Dimension; ++axis) left(axis, level) = h(axis, 0);
    for (int i = 0; i < m - level; ++i)
      for (int axis = 0; axis < Dimension; ++axis) h(axis, i) = (h(axis, i) + h(axis, i + 1)) / 2;
  }
  return left;
}

}  // namespace bezierbench
