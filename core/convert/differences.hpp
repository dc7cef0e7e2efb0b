// SPDX-License-Identifier: MIT
// Formula: q_j = C(n,j) D^j b_0 with the forward differences D^j b_i = D^(j-1) b_(i+1) - D^(j-1) b_i.
// Bound: one rounding a level, n in all, one product and the roundings of C(n,j). Differences and integer multiples of
//   subnormals are exact, so nothing underflows.
// Fails: the power coefficients themselves grow like 3^n, past the range from degree 641 on (77 in float).
#pragma once

#include "core/binomial.hpp"
#include "core/convert/conversion.hpp"
#include "core/convert/neighbour_levels.hpp"
#include "core/vector/same_for_every_axis.hpp"

namespace bezierbench {

struct Differences : SameForEveryAxis {
  static constexpr MethodInfo info{
      .id = "differences",
      .label = "Forward differences",
      .problem = Problem::conversion,
      .form = Form::bernstein,
      .max_degree = max_degree_to_power,
      .max_degree_float = max_degree_to_power_float,
      .bound = ErrorBound{.text = "gamma_(n+1) sum |b_i| C(n,i) t^i (1+t)^(n-i), and n more roundings past n = 54",
                          .amplification = Amplification::bernstein_to_power,
                          .factor = [](int n, double u) { return gamma_over_u(n + 1 + binomial_roundings(n, u), u); },
                          .underflow = [](int) { return 0.0; },
                          .underflow_scales_with_coefficients = true,
                          .growth = growth_to_power},
      .flops = "d n(n+1)/2 + d(n+1) + 3n/2 per curve",
      .cost_exponent = 2,
      .citation = "[Farin 2002], monomial form"};

  static constexpr double coefficient_growth(int n) { return growth_to_power(n); }

  static constexpr Form target = Form::power;
  static constexpr bool of_differences = true;

  template <class Scalar, int Dimension, int Degree>
  static Curve<Form::power, Scalar, Dimension, computed_degree<Degree>> convert(
      const Curve<Form::bernstein, Scalar, Dimension, Degree>& b) {
    const int n = b.degree();
    const BinomialRow<Scalar, computed_degree<Degree>> binomial(n);
    Curve<Form::power, Scalar, Dimension, computed_degree<Degree>> q(n);
    for (int i = 0; i <= n; ++i)
      for (int axis = 0; axis < Dimension; ++axis) q(axis, i) = b(axis, i);
    for (int axis = 0; axis < Dimension; ++axis)  // coefficient j becomes D^j b_0
      combine_neighbours([&](int i) -> Scalar& { return q(axis, i); }, n,
                         [](const Scalar& here, const Scalar& before) -> Scalar { return here - before; });
    for (int j = 0; j <= n; ++j)
      for (int axis = 0; axis < Dimension; ++axis) q(axis, j) = binomial[j] * q(axis, j);
    return q;
  }
};

}  // namespace bezierbench
