// SPDX-License-Identifier: MIT
// The concept of a conversion: `info`, the form of the result, and one function from a curve to the same curve in that
// form.
#pragma once

#include <concepts>

#include "core/bound/amplification.hpp"
#include "core/curve.hpp"
#include "core/method.hpp"

namespace bezierbench {

/// The bound of a conversion states what its coefficient errors can do to the curve: on each axis
/// sum |computed - true coefficient| |basis function(t)| <= factor u A + underflow eta S (x + y)^n.
/// `coefficient_growth(n)` bounds max|converted| / max|given|. A conversion that declares `of_differences` keeps b_0 as
/// coefficient 0 and computes the others from differences of control points: moving the whole curve does not change
/// them, and its bound also holds with |c_i - c_0| for every |c_i| in A.
template <class C>
concept Conversion = requires(const Curve<C::info.form, double, 2>& curve) {
  requires C::info.problem == Problem::conversion;
  { C::coefficient_growth(1) } -> std::same_as<double>;
  { C::convert(curve) } -> std::same_as<Curve<C::target, double, 2>>;
};

/// Growth of coefficients into power form: max_j C(n,j) 2^j, below 3^n.
constexpr double growth_to_power(int n) { return integer_power(3.0, n); }

/// The largest degrees at which the power coefficients of a curve with coordinates in [-1, 1], and the n + 1 terms of a
/// sum over them, stay in range by this growth: (n + 1) 3^n.
inline constexpr int max_degree_to_power = 640;
inline constexpr int max_degree_to_power_float = 76;

/// Growth of coefficients into Bernstein form: the norm n + 1 of the inverse matrix.
constexpr double growth_to_bernstein(int n) { return n + 1; }

}  // namespace bezierbench
