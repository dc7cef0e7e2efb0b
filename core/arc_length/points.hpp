// SPDX-License-Identifier: MIT
// Points of a curve whose hodograph is given, and the effect of roundings on the chords between them.
#pragma once

#include <algorithm>
#include <cmath>

#include "core/bound/error_bound.hpp"
#include "core/curve.hpp"

namespace bezierbench {

/// The curve with this hodograph that begins at the origin.
template <int Dimension>
Curve<Form::bernstein, double, Dimension> curve_of(const Curve<Form::bernstein, double, Dimension>& hodograph) {
  const int n = hodograph.degree() + 1;
  Curve<Form::bernstein, double, Dimension> curve(n);
  for (int axis = 0; axis < Dimension; ++axis) {
    curve(axis, 0) = 0;
    for (int i = 0; i < n; ++i) curve(axis, i + 1) = curve(axis, i) + hodograph(axis, i) / n;
  }
  return curve;
}

/// The largest error of one chord due to roundings: those of the evaluation of two points by Horner-Bernstein.
template <int Dimension>
double rounding_of_chord(const Curve<Form::bernstein, double, Dimension>& curve) {
  constexpr double u = 0x1p-53;
  double largest = 0;
  for (int i = 0; i <= curve.degree(); ++i)
    for (int axis = 0; axis < Dimension; ++axis) largest = std::max(largest, std::abs(curve(axis, i)));
  return 2 * Dimension * u * gamma_over_u(4 * curve.degree() + 8, u) * largest;
}

}  // namespace bezierbench
