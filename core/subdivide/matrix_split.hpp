// SPDX-License-Identifier: MIT
// Formula: left_k = sum_(j=0..k) m_kj b_j and right_(n-k) = sum_(j=0..k) m_kj b_(n-k+j) with m_kj = C(k,j) t^j
//   (1-t)^(k-j) from tables of powers: the matrix M^-1 diag(1, t, .., t^n) M, M from Bernstein to power form,
//   multiplied out, so that all its entries are Bernstein values and positive on [0,1]. Applied factor by factor it
//   would amplify errors like 3^n.
// Cost: about 3 n(n+1)/4 flops more for the binomials.
// Bound: the term of b_j has j-1 roundings in t^j, 2(k-j)-1 in (1-t)^(k-j) through 1-t, two in the products for m_kj
//   (none for j = 0 and j = k), one in the product with b_j, and k-j+1 additions (k for j = 0); the largest are j = 0
//   and j = 1 with 3k: gamma_3k sum |b_j| B_j,k(t), and the roundings of C(k,j). Underflow in powers, C(k,j) and
//   products loses at most k C(k,j) + 1 times eta/2 in an entry, in the sum (k+1) 2^k (1 + max |b_j|) eta/2,
//   magnified by less than 2.
// Fails: t^j and (1-t)^(k-j) underflow for large degrees; C(n,j) overflows past degree 1029 (131 in float).
#pragma once

#include "core/binomial.hpp"
#include "core/powers.hpp"
#include "core/subdivide/subdivision.hpp"

namespace bezierbench {

struct MatrixSplit {
  static constexpr SplitBound bound{
      .text = "gamma_3k p~ of a control point of k levels, and k more roundings past k = 54",
      .amplification = SplitAmplification::p_tilde,
      .factor = [](int k, double u) { return gamma_over_u(3 * k + (k > 1 ? binomial_roundings(k, u) : 0), u); },
      .underflow = [](int k) { return (k + 1) * integer_power(2.0, k); },
      .underflow_scales_with_coefficients = true};
  static constexpr SplitPromises promises{.keeps_ends = true,
                                          .shares_junction = true,
                                          .exact_at_zero = true,
                                          .exact_at_one = true,
                                          .reproduces_constants = false,
                                          .mirrors = false};
  static constexpr MethodInfo info{.id = "matrix_split",
                                   .label = "Matrix of Bernstein values",
                                   .problem = Problem::subdivision,
                                   .form = Form::bernstein,
                                   .max_degree_float = 131,
                                   .promise = bound.text,
                                   .one_minus_t = OneMinusT::summed,
                                   .flops = "2d (n+1)(n+1) + (n+1)(n+2) + 2n",
                                   .cost_exponent = 2,
                                   .citation = "[Pomax 2011], splitting curves using matrices; [Joy 2000]"};

  template <class Scalar, int Dimension, int Degree>
  static Halves<Curve<Form::bernstein, Scalar, Dimension, Degree>> split(
      const Curve<Form::bernstein, Scalar, Dimension, Degree>& curve, Scalar t) {
    const int n = curve.degree();
    const auto t_power = powers<Degree>(t, n);
    const auto s_power = powers<Degree>(Scalar(Scalar(1) - t), n);
    auto row = per_coefficient<Scalar, dynamic>(n);
    Halves<Curve<Form::bernstein, Scalar, Dimension, Degree>> halves{curve, curve};
    for (int k = 0; k <= n; ++k) {
      const auto binomial = binomials<Scalar, dynamic>(k);
      for (int j = 0; j <= k; ++j) row[j] = binomial[j] * (t_power[j] * s_power[k - j]);
      for (int axis = 0; axis < Dimension; ++axis) {
        halves.left(axis, k) = product(row, k, curve, axis, 0);
        halves.right(axis, n - k) = product(row, k, curve, axis, n - k);
      }
    }
    return halves;
  }

 private:
  /// base^0 .. base^n.
  template <int Degree, class Scalar>
  static PerCoefficient<Scalar, Degree> powers(const Scalar& base, int n) {
    auto power = per_coefficient<Scalar, Degree>(n);
    power[0] = Scalar(1);
    for (int i = 1; i <= n; ++i) power[i] = power[i - 1] * base;
    return power;
  }

  /// sum_(j=0..k) row_j b_(first+j), summed from j = 0 on.
  template <class Row, class Scalar, int Dimension, int Degree>
  static Scalar product(const Row& row, int k, const Curve<Form::bernstein, Scalar, Dimension, Degree>& curve, int axis,
                        int first) {
    Scalar sum = row[0] * curve(axis, first);
    for (int j = 1; j <= k; ++j) sum += row[j] * curve(axis, first + j);
    return sum;
  }
};

}  // namespace bezierbench
