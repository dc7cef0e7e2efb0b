// SPDX-License-Identifier: MIT
// What a conversion is: data about itself and one function from a curve in one form to the same curve in the other.
#pragma once

#include <concepts>

#include "core/curve.hpp"
#include "core/method.hpp"

namespace bezierbench {

constexpr Form other(Form form) { return form == Form::bernstein ? Form::power : Form::bernstein; }

/// The bound of a conversion states what its coefficient errors can do to the curve: on each axis
/// sum |computed - true coefficient| |basis function(t)| <= factor u A + underflow eta S (x + y)^n.
template <class C>
concept Conversion = requires(const Curve<C::info.form, double, 2>& curve) {
  requires C::info.problem == Problem::conversion;
  { C::convert(curve) } -> std::same_as<Curve<other(C::info.form), double, 2>>;
};

/// Underflow of a rounded conversion: n+1 terms in each of n+1 coefficients, scaled by weights below 3^n.
constexpr double conversion_underflow(int n) {
  double power = 1;
  for (int i = 0; i < n; ++i) power *= 3;
  return 2.0 * (n + 2) * (n + 2) * power;
}

}  // namespace bezierbench
