// SPDX-License-Identifier: MIT
// Formula: p = sum v_i A_i, A_i = (2t)^i (1-t)^(i+2) for i < floor(n/2), A_(n-i)(t) = A_i(1-t), and in the middle
//   (2t(1-t))^m for n = 2m, (2t(1-t))^m times 1-t and t for n = 2m+1. From the middle outwards, for i = m-1, ..., 0:
//     a = (1-t) v_i + t c,  b = (1-t) c + t v_(n-i),  c = (1-t) a + t b;  c starts as v_m or (1-t) v_m + t v_(m+1).
// Cost: O(d) memory; `prepare` takes about (3 + 4d) n^2/4.
// Coefficients: with S_i(L+1) = S_i(L) - S_(i-1)(L-1)/2, S_i(0) = 0 and S_i(1) = 1,
//     v_i = sum over k <= n/2 of C(n,k) 2^-k (S_(i-k)(n-2k+2) b_k - S_(i-k-2)(n-2k-2)/4 b_(n-k)),
//   derived in docs/proofs/wang_ball.md. Each weight V_ik of b_k in v_i has a relative error of a few n u.
// Bound: gamma_(5n+5) sum_k |b_k| sum_i |V_ik| A_i(t) on [0,1], and n more roundings past n = 54; about 1.41^n max|b|
//   at the worst t. It is not a multiple of an amplification in core/bound/error_bound.hpp, so `info` states none.
// Fails: the coefficients grow like 1.7^n, and their rounding costs a factor of 1.41^n: all digits by about n = 110.
#pragma once

#include <tuple>

#include "core/binomial.hpp"
#include "core/evaluate/evaluator.hpp"
#include "core/evaluate/schemes/steps.hpp"
#include "core/powers.hpp"

namespace bezierbench {

struct WangBall {
  static constexpr MethodInfo info{.id = "wang_ball",
                                   .label = "Wang-Ball",
                                   .form = Form::bernstein,
                                   .max_degree_float = 131,
                                   .flops = "9dn/2 + 1, 3d/2 fewer for odd n",
                                   .prepare_exponent = 2,
                                   .citation = "[Wang 1987]; [Phien and Dejdumrong 2000]; [Fuda et al. 2024], RWB"};
  static constexpr LaneRegisters lanes{.per_axis = 1, .shared = 3};

  /// Column i holds v_i.
  template <class Scalar, int Dimension, int Degree>
  struct Prepared {
    Curve<Form::bernstein, Scalar, Dimension, Degree> ball;

    [[nodiscard]] auto parts() const { return std::tie(ball); }
  };

  template <class Scalar, int Dimension, int Degree>
  static Prepared<Scalar, Dimension, Degree> prepare(const Curve<Form::bernstein, Scalar, Dimension, Degree>& curve) {
    const int n = curve.degree();
    const Scalar half = Scalar(1) / Scalar(2);
    const auto binomial = binomials<Scalar, Degree>(n);
    Prepared<Scalar, Dimension, Degree> prepared{curve};
    for (int i = 0; i <= n; ++i)
      for (int axis = 0; axis < Dimension; ++axis) prepared.ball(axis, i) = Scalar(0);
    auto last = per_coefficient<Scalar, Degree>(n);  // S(length - 1)
    auto row = per_coefficient<Scalar, Degree>(n);   // S(length)
    for (int i = 0; 2 * i <= n; ++i) {
      last[i] = Scalar(0);
      row[i] = Scalar(1);
    }
    const auto add = [&](int k, int shift, const Scalar& scale, bool mirrored) {
      for (int i = k + shift; 2 * i <= n; ++i) {
        const Scalar weight = scale * row[i - k - shift];
        for (int axis = 0; axis < Dimension; ++axis) {
          prepared.ball(axis, i) += weight * curve(axis, mirrored ? n - k : k);
          if (2 * i < n) prepared.ball(axis, n - i) += weight * curve(axis, mirrored ? k : n - k);
        }
      }
    };
    for (int length = 1; length <= n + 2; ++length) {
      if ((n - length) % 2 == 0) {
        const int k = (n - length) / 2 + 1;
        if (2 * k <= n) add(k, 0, binomial[k] * integer_power(half, k), false);
        if (k >= 2) add(k - 2, 2, -(binomial[k - 2] * integer_power(half, k)), true);
      }
      for (int i = n / 2; i >= 0; --i) {
        const Scalar next = i > 0 ? Scalar(row[i] - half * last[i - 1]) : row[i];
        last[i] = row[i];
        row[i] = next;
      }
    }
    return prepared;
  }

  template <class Scalar, int Dimension, int Degree>
  static Point<Scalar, Dimension> evaluate(const Prepared<Scalar, Dimension, Degree>& prepared, Scalar t) {
    const auto& v = prepared.ball;
    const int n = v.degree();
    const Scalar s = Scalar(1) - t;
    Point<Scalar, Dimension> c;
    for (int axis = 0; axis < Dimension; ++axis)
      c[axis] = n % 2 == 0 ? v(axis, n / 2) : Scalar(s * v(axis, n / 2) + t * v(axis, n / 2 + 1));
    count_down<Scalar, Degree>((n + 1) / 2 - 1 - n % 2, [&](int i) {
      for (int axis = 0; axis < Dimension; ++axis) {
        const Scalar a = s * v(axis, i) + t * c[axis];
        const Scalar b = s * c[axis] + t * v.from_end(axis, i);
        c[axis] = s * a + t * b;
      }
    });
    return c;
  }
};

}  // namespace bezierbench
