// SPDX-License-Identifier: MIT
// Formula: b_i = sum_(j<=i) C(i,j)/C(n,j) q_j, the inverse matrix in closed form. All its weights are positive and at
//   most 1.
// Bound: a weight has at most 2 binomials and a quotient rounded, its product 1, the sum n. The weights over row i
//   times |q_j| sum to p~ of the power form (core/bound/amplification.hpp), so the amplification is at most n + 1. A
//   product may underflow, by eta/2.
// Fails: past degree 1029 (131 in float), as every method that needs binomials.
#pragma once

#include "core/binomial.hpp"
#include "core/convert/conversion.hpp"
#include "core/vector/same_for_every_axis.hpp"

namespace bezierbench {

struct PositiveSum : SameForEveryAxis {
  static constexpr MethodInfo info{
      .id = "positive_sum",
      .label = "Positive sum",
      .problem = Problem::conversion,
      .form = Form::power,
      .max_degree_float = 131,
      .bound =
          ErrorBound{.text = "gamma_(n+2) sum |q_j| t^j on [0,1], and 4n more roundings past n = 54",
                     .amplification = Amplification::power_to_bernstein,
                     .factor = [](int n, double u) { return gamma_over_u(n + 2 + 4 * binomial_roundings(n, u), u); },
                     .underflow = [](int n) { return 2.0 * (n + 1); },
                     .underflow_scales_with_coefficients = true,
                     .growth = growth_to_bernstein},
      .flops = "(n+1)(n+2)(3/2+d) per curve",
      .cost_exponent = 2,
      .citation = "[Farouki and Rajan 1987]"};

  static constexpr double coefficient_growth(int n) { return growth_to_bernstein(n); }

  static constexpr Form target = Form::bernstein;

  template <class Scalar, int Dimension, int Degree>
  static Curve<Form::bernstein, Scalar, Dimension, computed_degree<Degree>> convert(
      const Curve<Form::power, Scalar, Dimension, Degree>& q) {
    const int n = q.degree();
    const BinomialRow<Scalar, computed_degree<Degree>> n_choose(n);
    Curve<Form::bernstein, Scalar, Dimension, computed_degree<Degree>> b(n);
    for (int i = 0; i <= n; ++i) {
      const bool tabulated = i <= exact_binomial_degree;
      const double* exact = detail::binomial_table<double>.data() + (tabulated ? detail::entries_before(i) : 0);
      const double scale = binomial_scale(i);
      double i_choose_j = 1 / scale;  // C(i, j) over the scale
      Point<Scalar, Dimension> sum = Point<Scalar, Dimension>::Zero();
      for (int j = 0; j <= i; ++j) {
        if (tabulated)
          i_choose_j = exact[j];  // here the scale is 1
        else if (j > 0)
          i_choose_j = i_choose_j * (i - j + 1) / j;
        const SharedBy<Scalar> weight = static_cast<SharedBy<Scalar>>(i_choose_j * scale) / n_choose[j];
        for (int axis = 0; axis < Dimension; ++axis) sum[axis] += weight * q(axis, j);
      }
      for (int axis = 0; axis < Dimension; ++axis) b(axis, i) = sum[axis];
    }
    return b;
  }
};

}  // namespace bezierbench
