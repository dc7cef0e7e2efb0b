// SPDX-License-Identifier: MIT
// Formula: p = c_0; p = p (1-t) + c_i t^i for i = 1..n, with c_i = C(n,i) b_i from `prepare` and t^i as a running
//   product.
// Bound: gamma_(3n+1) p~, and n more roundings past n = 54. Term i has 1 + binomial roundings in c_i, i-1 in t^i, 1
//   product, 1 addition and 3 per later step (1-t, product, sum). The most are 3n + binomial roundings for i = 1; for i
//   = 0 there are 3n. A t^i that underflows loses up to C(n,i) max|b| eta. After step i, p is at most
//   sum_(j<=i) C(n,j) |t|^j |1-t|^(i-j) max|b|, and C(n,j) <= C(n,i) C(i,j) makes it C(n,i) (|t| + |1-t|)^i max|b|.
// Keeps: ends_exact: at t = 0 every step is p 1 + c_i 0 = p = b_0, at t = 1 the last one is p 0 + c_n 1 = b_n.
//   axes_independent: a coordinate is computed from its own axis and t. scaling_by_two: t^i, c_i t^i and p of step i
//   are multiples of tau^i and beta tau^i as in docs/proofs/de_casteljau.md, and at most 2^n max|b|. total: no
//   number is larger than (2 (1 + |t|))^n (1 + u)^(4n) max(1, |b|). reversal and finite for n = 1: that is a step of
//   de_casteljau.
// Fails: C(n,i) b_i overflows at high degrees (always past 1029, in float past 131). t^i underflows for large n.
#pragma once

#include <tuple>

#include "core/binomial.hpp"
#include "core/bound/amplification.hpp"
#include "core/evaluate/evaluator.hpp"
#include "core/evaluate/guarantee.hpp"
#include "core/evaluate/schemes/steps.hpp"
#include "core/vector/same_for_every_axis.hpp"

namespace bezierbench {

struct HornerBernstein : SameForEveryAxis {
  static constexpr MethodInfo info{
      .id = "horner_bernstein",
      .label = "Horner-Bernstein",
      .form = Form::bernstein,
      .max_degree_float = 131,
      .bound =
          ErrorBound{.text = "gamma_(3n+1) p~, and n more roundings past n = 54",
                     .amplification = Amplification::p_tilde_bernstein,
                     .factor = [](int n, double u) { return gamma_over_u(3 * n + 1 + binomial_roundings(n, u), u); },
                     .underflow = [](int n) { return 2 * (n + 1) * integer_power(2.0, n); },
                     .underflow_scales_with_coefficients = true,
                     .growth = central_binomial},
      .one_minus_t = OneMinusT::summed,
      .flops = "n(1+3d) + 1",
      .citation = "[Farin 2002], nested multiplication"};
  static constexpr LaneRegisters lanes{.per_axis = 1, .shared = 1};

  static constexpr std::array guarantees{Guarantee{Property::ends_exact},       Guarantee{Property::reversal, 1},
                                         Guarantee{Property::finite, 1},        Guarantee{Property::scaling_by_two},
                                         Guarantee{Property::axes_independent}, Guarantee{Property::total}};

  static constexpr int largest_fixed_degree = 6;  ///< beyond, its steps take longer than to enter them

  /// Column i holds C(n,i) b_i.
  template <class Scalar, int Dimension, int Degree>
  struct Prepared {
    Curve<Form::bernstein, Scalar, Dimension, Degree> scaled;

    [[nodiscard]] auto parts() const { return std::tie(scaled); }
  };

  template <class Scalar, int Dimension, int Degree>
  static auto prepare(const Curve<Form::bernstein, Scalar, Dimension, Degree>& curve) {
    constexpr int computed = computed_degree<Degree>;
    const int n = curve.degree();
    const BinomialRow<Scalar, computed> binomial(n);
    Prepared<Scalar, Dimension, computed> prepared{Curve<Form::bernstein, Scalar, Dimension, computed>(n)};
    for (int i = 0; i <= n; ++i) {
      Point<Scalar, Dimension> scaled;
      for (int axis = 0; axis < Dimension; ++axis) scaled[axis] = curve(axis, i) * binomial[i];
      for (int axis = 0; axis < Dimension; ++axis) prepared.scaled(axis, i) = scaled[axis];
    }
    return prepared;
  }

  template <class Scalar, int Dimension, int Degree>
  static Point<Scalar, Dimension> evaluate(const Prepared<Scalar, Dimension, Degree>& prepared, Scalar t) {
    const int n = prepared.scaled.degree();
    const Scalar s = Scalar(1) - t;
    Point<Scalar, Dimension> p;
    for (int axis = 0; axis < Dimension; ++axis) p[axis] = prepared.scaled(axis, 0);
    Scalar t_power = Scalar(1);
    count_down<Scalar, Degree>(n - 1, [&](int left) {
      t_power *= t;
      for (int axis = 0; axis < Dimension; ++axis)
        p[axis] = p[axis] * s + prepared.scaled.from_end(axis, left) * t_power;
    });
    return p;
  }
};

}  // namespace bezierbench
