// SPDX-License-Identifier: MIT
// Scaling of a curve by a power of two, so that coordinates of any size have the same results.
#pragma once

#include <algorithm>
#include <cmath>

#include "core/curve.hpp"

namespace bezierbench {

/// Scales h by a power of two such that its largest coordinate is in [1/2, 1); returns the exponent that was taken out.
/// 0 stays 0.
template <int Dimension>
int normalise(Curve<Form::bernstein, double, Dimension>& h) {
  double largest = 0;
  for (int i = 0; i <= h.degree(); ++i)
    for (int axis = 0; axis < Dimension; ++axis) largest = std::max(largest, std::abs(h(axis, i)));
  int exponent = 0;
  std::frexp(largest, &exponent);
  for (int i = 0; i <= h.degree(); ++i)
    for (int axis = 0; axis < Dimension; ++axis) h(axis, i) = std::ldexp(h(axis, i), -exponent);
  return exponent;
}

/// True where all control vectors are 0: a point has no length, and that is known without a method.
template <int Dimension>
bool is_zero(const Curve<Form::bernstein, double, Dimension>& h) {
  for (int i = 0; i <= h.degree(); ++i)
    for (int axis = 0; axis < Dimension; ++axis)
      if (h(axis, i) != 0) return false;
  return true;
}

}  // namespace bezierbench
