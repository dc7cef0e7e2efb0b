// SPDX-License-Identifier: MIT
// Formula: r_j = q_j / C(n,j); then b_i = sum_j C(i,j) r_j by an additive triangle: level k adds neighbours, n levels.
// Source: the inverse of the difference triangle (core/convert/differences.hpp), D^j b_0 = r_j, undone by D^(j-1)
//   b_(i+1) = D^(j-1) b_i + D^j b_i.
// Bound: one quotient, the roundings of C(n,j), at most n additions, all weights positive. A quotient may underflow, by
//   eta/2, which b_i repeats up to 2^n times.
// Fails: past degree 1029 (131 in float), as every method that needs binomials.
#pragma once

#include "core/binomial.hpp"
#include "core/convert/conversion.hpp"
#include "core/convert/neighbour_levels.hpp"
#include "core/vector/same_for_every_axis.hpp"

namespace bezierbench {

struct Triangle : SameForEveryAxis {
  static constexpr MethodInfo info{
      .id = "triangle",
      .label = "Additive triangle",
      .problem = Problem::conversion,
      .form = Form::power,
      .max_degree_float = 131,
      .bound = ErrorBound{.text = "gamma_(n+1) sum |q_j| t^j on [0,1], and n more roundings past n = 54",
                          .amplification = Amplification::power_to_bernstein,
                          .factor = [](int n, double u) { return gamma_over_u(n + 1 + binomial_roundings(n, u), u); },
                          .underflow = [](int n) { return integer_power(2.0, n); },
                          .underflow_scales_with_coefficients = true,
                          .growth = growth_to_bernstein},
      .flops = "d n(n+1)/2 + d(n+1) + 3n/2 per curve",
      .cost_exponent = 2,
      .citation = "[Farin 2002], monomial form"};

  static constexpr double coefficient_growth(int n) { return growth_to_bernstein(n); }

  static constexpr Form target = Form::bernstein;

  template <class Scalar, int Dimension, int Degree>
  static Curve<Form::bernstein, Scalar, Dimension, computed_degree<Degree>> convert(
      const Curve<Form::power, Scalar, Dimension, Degree>& q) {
    const int n = q.degree();
    const BinomialRow<Scalar, computed_degree<Degree>> binomial(n);
    Curve<Form::bernstein, Scalar, Dimension, computed_degree<Degree>> b(n);
    for (int j = 0; j <= n; ++j)
      for (int axis = 0; axis < Dimension; ++axis) b(axis, j) = q(axis, j) / binomial[j];
    for (int axis = 0; axis < Dimension; ++axis)
      combine_neighbours([&](int i) -> Scalar& { return b(axis, i); }, n,
                         [](const Scalar& here, const Scalar& before) -> Scalar { return here + before; });
    return b;
  }
};

}  // namespace bezierbench
