// SPDX-License-Identifier: MIT
// Formula: q_j = sum_(i<=j) (-1)^(j-i) n!/(i!(n-j)!(j-i)!) b_i; the coefficient is formed first, multiplied by b_i, and
//   the products are added over i.
// Bound: the coefficient has 3 roundings (more once factorials are inexact, past n = 22), its product 1, the sum n.
//   A product may underflow, by eta/2.
// Fails: factorials overflow past n = 170 (34 in float). The power coefficients themselves grow like 3^n.
#pragma once

#include "core/convert/conversion.hpp"
#include "core/factorial.hpp"
#include "core/vector/same_for_every_axis.hpp"

namespace bezierbench {

struct Factorial : SameForEveryAxis {
  static constexpr MethodInfo info{
      .id = "factorial",
      .label = "Factorial quotients",
      .problem = Problem::conversion,
      .form = Form::bernstein,
      .max_degree = max_factorial,
      .max_degree_float = max_factorial_float,
      .bound =
          ErrorBound{.text = "gamma_(n+4) sum |b_i| C(n,i) t^i (1+t)^(n-i), and 4(n-22) more roundings past n = 22",
                     .amplification = Amplification::bernstein_to_power,
                     .factor = [](int n, double u) { return gamma_over_u(n + 4 + 4 * factorial_roundings(n, u), u); },
                     .underflow = [](int n) { return 1.0 * (n + 1) * (n + 1); },
                     .underflow_scales_with_coefficients = true,
                     .growth = growth_to_power},
      .flops = "(n+1)(n+2)(3/2+d) per curve",
      .cost_exponent = 2,
      .citation = "[Report 001], section 1.1"};

  static constexpr Form target = Form::power;
  static constexpr double coefficient_growth(int n) { return growth_to_power(n); }

  template <class Scalar, int Dimension, int Degree>
  static Curve<Form::power, Scalar, Dimension, computed_degree<Degree>> convert(
      const Curve<Form::bernstein, Scalar, Dimension, Degree>& b) {
    const int n = b.degree();
    const auto factorial = factorials<Scalar, computed_degree<Degree>>(n);
    Curve<Form::power, Scalar, Dimension, computed_degree<Degree>> q(n);
    for (int j = 0; j <= n; ++j) {
      Point<Scalar, Dimension> sum = Point<Scalar, Dimension>::Zero();
      for (int i = 0; i <= j; ++i) {
        const SharedBy<Scalar> magnitude = factorial[n] / (factorial[i] * factorial[n - j] * factorial[j - i]);
        const SharedBy<Scalar> coefficient = (j - i) % 2 == 0 ? magnitude : -magnitude;
        for (int axis = 0; axis < Dimension; ++axis) sum[axis] += coefficient * b(axis, i);
      }
      for (int axis = 0; axis < Dimension; ++axis) q(axis, j) = sum[axis];
    }
    return q;
  }
};

}  // namespace bezierbench
