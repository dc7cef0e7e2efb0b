// SPDX-License-Identifier: MIT
// Formula: p(t) = sum n!/(i!(n-i)!) t^i (1-t)^(n-i) b_i, terms formed and added in ascending order.
// Bound: gamma_(3n+2) p~. Term i has i-1 and n-i-1 roundings in its powers, n-i in (1-t)^(n-i) through 1-t, 3 products
//   and n additions; the most are 3n + 2, for i = 0. Factorials add 2 f(n) + 2 once they are no longer exact. Powers of
//   t that underflow lose up to C(n,i) max|b| eta. C(n,i) |t|^i is at most (1 + |t|)^n, which stays in range up to
//   |t| = 2 and is below (|t| + |1-t|)^n beyond; a term and the sum are at most (|t| + |1-t|)^n max|b|.
// Fails: factorials overflow past n = 170 (34 in float). The rounding of 1-t, common to most methods, is magnified n
//   times for small t.
#pragma once

#include <tuple>

#include "core/bound/amplification.hpp"
#include "core/evaluate/evaluator.hpp"
#include "core/evaluate/schemes/steps.hpp"
#include "core/factorial.hpp"
#include "core/vector/same_for_every_axis.hpp"

namespace bezierbench {

struct Direct : SameForEveryAxis {
  static constexpr MethodInfo info{
      .id = "direct",
      .label = "Direct (Bernstein sum)",
      .form = Form::bernstein,
      .max_degree = max_factorial,
      .max_degree_float = max_factorial_float,
      .bound = ErrorBound{.text = "gamma_(3n+2) p~, and 2(n-22)+2 more roundings past n = 22",
                          .amplification = Amplification::p_tilde_bernstein,
                          .factor =
                              [](int n, double u) {
                                const double f = factorial_roundings(n, u);
                                return gamma_over_u(3 * n + 2 + (f > 0 ? 2 * f + 2 : 0), u);
                              },
                          .underflow = [](int n) { return 2 * (n + 1) * integer_power(2.0, n); },
                          .underflow_scales_with_coefficients = true},
      .one_minus_t = OneMinusT::summed,
      .flops = "4n + 2d(n+1) + 2",
      .citation = "[Report 001], section 1.4"};
  static constexpr LaneRegisters lanes{.per_axis = 1, .shared = 2};

  static constexpr int largest_fixed_degree = 16;  ///< beyond, the code for every degree takes at most a tenth longer

  template <class Scalar, int Dimension, int Degree>
  struct Prepared {
    Curve<Form::bernstein, Scalar, Dimension, Degree> curve;
    SharedRow<Scalar, Degree> binomial;

    [[nodiscard]] auto parts() const { return std::tie(curve, binomial); }
  };

  template <class Scalar, int Dimension, int Degree>
  static auto prepare(const Curve<Form::bernstein, Scalar, Dimension, Degree>& curve) {
    constexpr int computed = computed_degree<Degree>;
    const int n = curve.degree();
    const auto factorial = factorials<Scalar, computed>(n);
    Prepared<Scalar, Dimension, computed> prepared{working_copy(curve), per_coefficient<SharedBy<Scalar>, computed>(n)};
    for (int i = 0; i <= n; ++i) prepared.binomial[i] = factorial[n] / (factorial[i] * factorial[n - i]);
    return prepared;
  }

  template <class Scalar, int Dimension, int Degree>
  static Point<Scalar, Dimension> evaluate(const Prepared<Scalar, Dimension, Degree>& prepared, Scalar t) {
    const int n = prepared.curve.degree();
    const Scalar s = Scalar(1) - t;
    Scalar s_powers[(Degree == dynamic ? max_factorial : Degree) + 1];
    Scalar s_power(1);
    s_powers[0] = s_power;
    count_down<Scalar, Degree>(n - 1, [&](int left) {
      s_power *= s;
      s_powers[n - left] = s_power;
    });
    Scalar t_power(1);
    Point<Scalar, Dimension> sum = Point<Scalar, Dimension>::Zero();
    const auto add = [&](int left) {
      const Scalar basis = prepared.binomial[left] * t_power * s_powers[left];
      for (int axis = 0; axis < Dimension; ++axis) sum[axis] += basis * prepared.curve.from_end(axis, left);
    };
    add(n);
    count_down<Scalar, Degree>(n - 1, [&](int left) {
      t_power *= t;
      add(left);
    });
    return sum;
  }
};

}  // namespace bezierbench
