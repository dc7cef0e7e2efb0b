// SPDX-License-Identifier: MIT
// A method on a curve of any size: coordinates and weights whose squares and products might overflow or underflow are
// first multiplied by powers of two, which changes no chord.
#pragma once

#include <algorithm>
#include <cmath>
#include <span>

#include "core/flatten/flattening.hpp"
#include "core/powers.hpp"

namespace bezierbench {

namespace detail {

/// The exponent of the largest number where that is far from 0, else 0.
inline int extreme_exponent(std::span<const double> numbers) {
  constexpr int far = 200;
  double largest = 0;
  for (const double x : numbers) largest = std::max(largest, std::abs(x));
  const int exponent = binary_exponent(largest);
  return std::abs(exponent) > far ? exponent : 0;
}

template <class Points>
std::span<const double> coordinates_of(const Points& points) {
  return {points.data(), static_cast<std::size_t>(points.dimension) * static_cast<std::size_t>(points.degree() + 1)};
}

template <class Points>
void scale(Points& points, int exponent) {
  for (int i = 0; i <= points.degree(); ++i)
    for (int axis = 0; axis < Points::dimension; ++axis)
      points(axis, i) = times_power_of_two(points(axis, i), -exponent);
}

}  // namespace detail

/// M::flatten(curve, tolerance, chords); of a rational curve, or one that is scaled, not complete where a point is not
/// finite, and of one that is scaled where the tolerance is so small that points are rounded to multiples of 2^-1074.
template <FlattenMethod M, Form F, int Dimension, int Degree>
void flatten_scaled(const Curve<F, double, Dimension, Degree>& curve, double tolerance, Flattening& chords) {
  constexpr bool rational = F == Form::rational;
  const auto control_points = [](auto& c) -> auto& {
    if constexpr (rational)
      return c.points;
    else
      return c;
  };
  const auto& ends = control_points(curve);
  const int exponent = detail::extreme_exponent(detail::coordinates_of(ends));
  int of_weights = 0;
  if constexpr (rational)
    of_weights = detail::extreme_exponent({curve.weights.data(), static_cast<std::size_t>(curve.weights.size())});
  if (exponent == 0 && of_weights == 0) {
    M::flatten(curve, tolerance, chords);
    if constexpr (!rational) return;
  } else {
    auto scaled = curve;
    detail::scale(control_points(scaled), exponent);
    if constexpr (rational)
      for (int i = 0; i <= curve.degree(); ++i) scaled.weights[i] = times_power_of_two(curve.weights[i], -of_weights);
    M::flatten(scaled, times_power_of_two(tolerance, -exponent), chords);
    for (double& x : chords.points) x = times_power_of_two(x, exponent);
    chords.complete = chords.complete && tolerance >= 0x1p-1040;
    for (int axis = 0; axis < Dimension; ++axis) {
      chords.points[static_cast<std::size_t>(axis)] = ends(axis, 0);
      *(chords.points.end() - Dimension + axis) = ends(axis, curve.degree());
    }
  }
  const auto is_finite = [](double x) { return std::isfinite(x); };
  chords.complete = chords.complete && std::ranges::all_of(chords.points, is_finite);
}

}  // namespace bezierbench
