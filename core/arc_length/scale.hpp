// SPDX-License-Identifier: MIT
// Scales hodographs, so that results do not depend on the size of the coordinates, and scales lengths back.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <limits>

#include "core/curve.hpp"
#include "core/derivative/hodograph.hpp"
#include "core/powers.hpp"

namespace bezierbench {

namespace detail {

inline constexpr int no_exponent = std::numeric_limits<int>::min();

/// The exponent e of the largest coordinate of an axis, which is in [2^(e-1), 2^e); no_exponent where all are 0.
template <int Dimension>
int exponent_of_axis(const Curve<Form::bernstein, double, Dimension>& curve, int axis) {
  double largest = 0;
  for (int i = 0; i <= curve.degree(); ++i) largest = std::max(largest, std::abs(curve(axis, i)));
  if (largest == 0) return no_exponent;
  return binary_exponent(largest);
}

/// Multiplies each axis by 2^(axis_exponents - common), with `common` such that the largest coordinate of all is in
/// [1/2, 1).
/// Returns `common`.
template <int Dimension>
int normalise(Curve<Form::bernstein, double, Dimension>& h, const std::array<int, Dimension>& axis_exponents) {
  int common = no_exponent;
  for (int axis = 0; axis < Dimension; ++axis)
    if (const int exponent = exponent_of_axis(h, axis); exponent != no_exponent)
      common = std::max(common, exponent + axis_exponents[static_cast<std::size_t>(axis)]);
  if (common == no_exponent) return 0;
  for (int axis = 0; axis < Dimension; ++axis)
    for (int i = 0; i <= h.degree(); ++i)
      h(axis, i) = times_power_of_two(h(axis, i), axis_exponents[static_cast<std::size_t>(axis)] - common);
  return common;
}

}  // namespace detail

/// Scales h by a power of two such that its largest coordinate is in [1/2, 1). Returns the exponent of the factor taken
/// out. A zero h stays zero.
template <int Dimension>
int normalise(Curve<Form::bernstein, double, Dimension>& h) {
  return detail::normalise<Dimension>(h, {});
}

/// Whether all control vectors are 0. The curve is then a point, and its length is 0.
template <int Dimension>
bool is_zero(const Curve<Form::bernstein, double, Dimension>& h) {
  for (int i = 0; i <= h.degree(); ++i)
    for (int axis = 0; axis < Dimension; ++axis)
      if (h(axis, i) != 0) return false;
  return true;
}

/// A hodograph divided by 2^exponent.
template <class Hodograph>
struct ScaledHodograph {
  /// Not an aggregate, all of which GCC would fill with zeros first: the room for max_degree.
  explicit ScaledHodograph(const Hodograph& hodograph) : h(hodograph) {}

  Hodograph h;
  int exponent = 0;

  [[nodiscard]] double in_units(double length) const { return times_power_of_two(length, -exponent); }

  /// 2^exponent times an error, rounded up.
  [[nodiscard]] double unscaled_error(double error) const {
    const double rounded = times_power_of_two(error, exponent);
    return in_units(rounded) < error ? std::nextafter(rounded, std::numeric_limits<double>::infinity()) : rounded;
  }
};

/// The first hodograph of a curve, scaled such that its largest coordinate is in [1/2, 1). Scaling comes after taking
/// differences: next to coordinates of 1e300, a difference of 1e-30 on another axis is a length, but 1e-330 would not
/// be. An axis is scaled before only as far as its differences would overflow; what its small coordinates lose by this
/// is below 2^-1000 of its large differences.
template <int Dimension>
auto scaled_hodograph(Curve<Form::bernstein, double, Dimension> curve) {
  std::array<int, Dimension> taken{};
  const int difference_bits = 1 + static_cast<int>(std::bit_width(static_cast<unsigned>(curve.degree())));
  for (int axis = 0; axis < Dimension; ++axis) {
    const int exponent = detail::exponent_of_axis(curve, axis);
    if (exponent <= std::numeric_limits<double>::max_exponent - difference_bits) continue;
    for (int i = 0; i <= curve.degree(); ++i) curve(axis, i) = times_power_of_two(curve(axis, i), -difference_bits);
    taken[static_cast<std::size_t>(axis)] = difference_bits;
  }
  ScaledHodograph result(hodograph(curve, 1));
  result.exponent = detail::normalise<Dimension>(result.h, taken);
  return result;
}

}  // namespace bezierbench
