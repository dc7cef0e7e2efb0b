// SPDX-License-Identifier: MIT
// Formula: row i of the lower triangular system sum_(k<=i) M_ik b_k = q_i, M_ik = (-1)^(i-k) n!/(k!(n-i)!(i-k)!),
//   solved in order: the sum over k < i is formed first, then subtracted from q_i, and the difference divided by the
//   diagonal.
// Bound: the computed b solves (M + dM) b = q with |dM| <= gamma_(n+5) |M| ([Higham 2002], Theorem 8.5, with the
//   roundings of M), so |b - true| <= gamma |M^-1||M||b|; the amplification grows like 3^n at t = 1. Doubling the
//   factor covers higher orders while gamma_(n+5) (5/3)^n <= 1/10; beyond, no bound holds. (Applying M^-1|M| k times
//   turns the sum into sum |q_j| x^j ((2k+1)x + y)^(n-j); (5x+y)/(3x+y) <= 5/3 for any x, y >= 0, and later ratios are
//   less.) A residual of r underflow units comes back as at most (n+1) r, the diagonal quotients as 2^n. A row
//   has magnitudes of at most 3^n in all, times the coefficients, at most (n+1) 3^n max|q|.
// Fails: exponentially. This explains the whole of the error that [Report 001] attributes to converting from power form
//   to Bernstein form; positive_sum does the same conversion without it.
#pragma once

#include "core/bound/amplification.hpp"
#include "core/convert/conversion.hpp"
#include "core/factorial.hpp"
#include "core/vector/same_for_every_axis.hpp"

namespace bezierbench {

struct ForwardSubstitution : SameForEveryAxis {
  static constexpr double bound_factor(int n, double u) {
    const double once = gamma_over_u(n + 5 + 4 * factorial_roundings(n, u), u);
    const bool first_order_holds = once * u * integer_power(5.0 / 3.0, n) <= 0.1;
    return first_order_holds ? 2 * once : std::numeric_limits<double>::infinity();
  }

  static constexpr MethodInfo info{
      .id = "forward_substitution",
      .label = "Forward substitution",
      .problem = Problem::conversion,
      .form = Form::power,
      .max_degree = max_factorial,
      .max_degree_float = max_factorial_float,
      .bound = ErrorBound{.text = "2 gamma_(n+5) sum |q_j| t^j (1+2t)^(n-j) while gamma (5/3)^n <= 1/10",
                          .amplification = Amplification::forward_substitution,
                          .factor = bound_factor,
                          .underflow = [](int n) { return 1.0 * (n + 2) * (n + 2) + integer_power(2.0, n); },
                          .underflow_scales_with_coefficients = true,
                          .growth = [](int n) { return (n + 1) * integer_power(9.0, n); }},
      .flops = "(n+1)(n+2)(3/2+d) per curve",
      .cost_exponent = 2,
      .citation = "[Report 001], section 1.2; [Higham 2002], Theorem 8.5"};

  static constexpr Form target = Form::bernstein;
  static constexpr double coefficient_growth(int n) { return (n + 1) * integer_power(3.0, n); }

  template <class Scalar, int Dimension, int Degree>
  static Curve<Form::bernstein, Scalar, Dimension, computed_degree<Degree>> convert(
      const Curve<Form::power, Scalar, Dimension, Degree>& q) {
    const int n = q.degree();
    const auto factorial = factorials<Scalar, computed_degree<Degree>>(n);
    Curve<Form::bernstein, Scalar, Dimension, computed_degree<Degree>> b(n);
    for (int i = 0; i <= n; ++i) {
      Point<Scalar, Dimension> sum = Point<Scalar, Dimension>::Zero();
      for (int k = 0; k < i; ++k) {
        const SharedBy<Scalar> magnitude = factorial[n] / (factorial[k] * factorial[n - i] * factorial[i - k]);
        const SharedBy<Scalar> entry = (i - k) % 2 == 0 ? magnitude : -magnitude;
        for (int axis = 0; axis < Dimension; ++axis) sum[axis] += entry * b(axis, k);
      }
      const SharedBy<Scalar> diagonal = factorial[n] / (factorial[i] * factorial[n - i]);
      for (int axis = 0; axis < Dimension; ++axis) b(axis, i) = (q(axis, i) - sum[axis]) / diagonal;
    }
    return b;
  }
};

}  // namespace bezierbench
