// SPDX-License-Identifier: MIT
// Formula: p = (1-t)^n sum c_i r^i with c_i = C(n,i) b_i and r = t/(1-t) for t <= 1/2, else mirrored. Each of c_i, 1-t,
//   r, the power, Horner's sum and their product is a pair value + error, to first order.
// Cost: two of the flops are divisions.
// Bound: u |p| + 2 gamma_(3n+9)^2 p~, and 4n u^2 p~ more past n = 54; about 18 n^2 u^2 p~ in all. `CorrectedPair`
//   bounds a pair's error part by k u and what the pair misses by q u^2, relative to its magnitude. A product has
//   k = k_a + k_b + 1. It misses the product of the two errors, k_a k_b, and rounds its correction: three times each k
//   and once its own error. Higher orders: no path of value or correction passes more than 4k roundings. (1-t)^n may
//   underflow, by up to 2^n max|b| eta, and so may each of its corrections.
// Fails: as volk_schumaker, the sum at r = 1 is up to 2^n max|b|. (1-t)^n underflows for n > 1022 at t = 1/2. Its error
//   part underflows for n > 969, and the correction is lost there.
#pragma once

#include <functional>
#include <tuple>

#include "core/binomial.hpp"
#include "core/bound/amplification.hpp"
#include "core/error_free.hpp"
#include "core/evaluate/evaluator.hpp"
#include "core/evaluate/methods/horner_bernstein.hpp"
#include "core/evaluate/methods/volk_schumaker.hpp"
#include "core/evaluate/schemes/nearer_end.hpp"
#include "core/evaluate/schemes/steps.hpp"
#include "core/powers.hpp"
#include "core/vector/same_for_every_axis.hpp"

namespace bezierbench {

/// Bounds of what a pair value + error misses; the header above derives them.
struct CorrectedPair {
  double k;  ///< |error| <= k u |value|
  double q;  ///< |exact - value - error| <= q u^2 |value|
};

constexpr CorrectedPair operator*(const CorrectedPair& a, const CorrectedPair& b) {
  return {a.k + b.k + 1, a.q + b.q + a.k * b.k + 3 * (a.k + b.k) + 1};
}

struct CompensatedVolkSchumaker : SameForEveryAxis {
  /// A power by squaring, base.error included: result.value + result.error = base^exponent to first order.
  template <class Scalar>
  static Expansion2<Scalar> power(const Expansion2<Scalar>& base, int exponent) {
    return power_by_squaring<Expansion2<Scalar>>(base, exponent, {Scalar(1), Scalar(0)}, product<Scalar>);
  }

  template <class Scalar>
  static Expansion2<Scalar> product(const Expansion2<Scalar>& a, const Expansion2<Scalar>& b) {
    const auto value = two_prod<Scalar>(a.value, b.value);
    return {value.value, value.error + (a.value * b.error + a.error * b.value)};
  }

  /// The same power in the algebra of the bound.
  static constexpr CorrectedPair power_bound(const CorrectedPair& base, int exponent) {
    return power_by_squaring<CorrectedPair>(base, exponent, {0, 0}, std::multiplies<>());
  }

  static constexpr double bound_factor(int n, double u) {
    // C(n,i) b_i: 2 roundings, the product and the sums of the correction, and the rounding and the error of the low
    // part of the binomial.
    const CorrectedPair coefficient{2, 4 + binomial_pair_roundings(n)};
    // The quotient of 1-t or t by t or 1-t: of its two errors one passes 3, one 4 roundings on the way into the error.
    const CorrectedPair ratio{2, 7};
    CorrectedPair sum = coefficient;
    for (int i = 1; i <= n; ++i) {  // sum r + c: the product, and two errors and c's low part, at most 4 roundings each
      const double rounded = 2 * sum.k + 3 * ratio.k + 8;
      sum = {sum.k + ratio.k + 2, sum.q + ratio.q + sum.k * ratio.k + rounded};
    }
    const CorrectedPair result = sum * power_bound({1, 0}, n);
    return result.q * u * (1 + gamma_over_u(4 * result.k, u) * u);
  }

  static constexpr MethodInfo info{
      .id = "compensated_volk_schumaker",
      .label = "Volk-Schumaker, compensated",
      .form = Form::bernstein,
      .max_degree_float = VolkSchumaker::info.max_degree_float,
      .bound = ErrorBound{.text = "u p~ + 2 gamma_(3n+9)^2 p~, and 4n u^2 p~ more past n = 54",
                          .amplification = Amplification::p_tilde_bernstein,
                          .factor = bound_factor,
                          .underflow = [](int n) { return 16.0 * (n + 1) * (n + 1) * integer_power(2.0, n); },
                          .underflow_scales_with_coefficients = true,
                          .growth = [](int n) { return integer_power(2.0, n); },
                          .result_roundings = 1},
      .fused = true,
      .flops = "at most 14dn + 7d + 12 log2 n + 19",
      .citation = "[Delgado and Pena 2016]; [Schumaker and Volk 1986]"};
  static constexpr LaneRegisters lanes{.per_axis = 2, .shared = 6};

  /// Columns i hold C(n,i) b_i, rounded, and the error of this rounding.
  template <class Scalar, int Dimension, int Degree>
  struct Prepared {
    Curve<Form::bernstein, Scalar, Dimension, Degree> scaled;
    Curve<Form::bernstein, Scalar, Dimension, Degree> lost;

    [[nodiscard]] auto parts() const { return std::tie(scaled, lost); }
  };

  template <class Scalar, int Dimension, int Degree>
  static auto prepare(const Curve<Form::bernstein, Scalar, Dimension, Degree>& curve) {
    constexpr int computed = computed_degree<Degree>;
    const int n = curve.degree();
    const auto binomial = binomial_pairs<Scalar, computed>(n);
    using Coefficients = Curve<Form::bernstein, Scalar, Dimension, computed>;
    Prepared<Scalar, Dimension, computed> prepared{Coefficients(n), Coefficients(n)};
    for (int i = 0; i <= n; ++i)
      for (int axis = 0; axis < Dimension; ++axis) {
        const auto scaled = two_prod<Scalar>(binomial.high[i], curve(axis, i));
        prepared.scaled(axis, i) = scaled.value;
        prepared.lost(axis, i) = scaled.error + binomial.low[i] * curve(axis, i);
      }
    return prepared;
  }

  /// smaller / larger, with the errors of both.
  template <class Scalar>
  static Expansion2<Scalar> quotient(const Expansion2<Scalar>& smaller, const Expansion2<Scalar>& larger) {
    const Scalar value = smaller.value / larger.value;
    const Scalar remainder = fused<Scalar>(-value, larger.value, smaller.value);
    return {value, (remainder + (smaller.error - value * larger.error)) / larger.value};
  }

  template <class Scalar, int Dimension, int Degree>
  static Point<Scalar, Dimension> evaluate(const Prepared<Scalar, Dimension, Degree>& prepared, Scalar t) {
    const int n = prepared.scaled.degree();
    const auto s = two_sum<Scalar>(Scalar(1), -t);
    const auto near_start = t + t <= Scalar(1);
    const Expansion2<Scalar> larger{select(near_start, s.value, t), select(near_start, s.error, Scalar(0))};
    const Expansion2<Scalar> smaller{select(near_start, t, s.value), select(near_start, Scalar(0), s.error)};
    const auto ratio = quotient<Scalar>(smaller, larger);
    const auto scale = power<Scalar>(larger, n);
    const FromNearerEnd scaled(near_start, prepared.scaled);
    const FromNearerEnd lost(near_start, prepared.lost);
    Point<Scalar, Dimension> p;
    Point<Scalar, Dimension> error;
    for (int axis = 0; axis < Dimension; ++axis) {
      p[axis] = scaled(axis, n);
      error[axis] = lost(axis, n);
    }
    count_down<Scalar, Degree>(n - 1, [&](int i) {
      for (int axis = 0; axis < Dimension; ++axis) {
        const auto product = two_prod<Scalar>(p[axis], ratio.value);
        const auto sum = two_sum<Scalar>(product.value, scaled(axis, i));
        const Scalar local = p[axis] * ratio.error + ((product.error + sum.error) + lost(axis, i));
        error[axis] = error[axis] * ratio.value + local;
        p[axis] = sum.value;
      }
    });
    for (int axis = 0; axis < Dimension; ++axis) {
      const auto result = product<Scalar>({p[axis], error[axis]}, scale);
      p[axis] = result.value + result.error;
    }
    return p;
  }
};

}  // namespace bezierbench
