// SPDX-License-Identifier: MIT
// Formula: the double nearest to p, ties to even. First p = L^n sum c_i r^i with c_i = C(n,i) b_i, L = 1-t and r = t/L,
//   or mirrored where L^n is out of range, each of c_i, L, r, the power and the sum a pair value + error. Where the
//   bound of the pair leaves two numbers to choose from: the same with the bound in terms of p~; then exact integers
//   (correctly_rounded_integers.hpp).
// Cost: the flops are those where the pair decides, two of them divisions: at all but about 2^-38 max|b| / |p| of
//   random points at n = 20. The integers take microseconds there.
// Bound: u |p|, and eta/2 where the result is subnormal: it is correctly rounded. That of the pair is
//   e = 2 (q + k) u^2 max|b|, derived in docs/proofs/correctly_rounded.md.
// Keeps: all properties that the exact p has and monotone rounding does not lose; proved there, too.
// Fails: where the curve is subnormal, or p cancels to below 2^-38 max|b|, a point takes microseconds. t outside [0,1]
//   is outside its domain and gives NaN.
#pragma once

#include <algorithm>
#include <bit>
#include <cstdint>

#include "core/binomial.hpp"
#include "core/evaluate/guarantee.hpp"
#include "core/evaluate/methods/compensated_volk_schumaker.hpp"
#include "core/evaluate/schemes/correctly_rounded_pair.hpp"
#include "core/powers.hpp"

namespace bezierbench {

struct CorrectlyRounded {
  /// e / (u^2 max|b|), and the same for p~ in place of max|b|.
  static constexpr double pair_factor(int n) {
    const double steps = n + 1;
    const CorrectedPair sum{6 * steps, steps * (27 + binomial_pair_roundings(n)) + 9 * steps * (steps + 1)};
    const CorrectedPair result = sum * CompensatedVolkSchumaker::power_bound({1, 0}, n);
    return 2 * (result.q + result.k);
  }

  static constexpr MethodInfo info{
      .id = "correctly_rounded",
      .label = "correctly rounded",
      .form = Form::bernstein,
      .max_degree = rounded_max_degree,
      .max_degree_float = 64,
      .unit_interval_only = true,
      .bound = ErrorBound{.text = "u p~ on [0,1]",
                          .amplification = Amplification::p_tilde_bernstein,
                          .factor = [](int /*n*/, double /*u*/) { return 0.0; },
                          .underflow = [](int /*n*/) { return 0.5; },  // where the result is subnormal
                          .unit_interval_only = true,
                          .result_roundings = 1},
      .fused = true,
      .flops = "at most 10dn + 8d + 8 log2 n + 16",
      .citation = "[Schumaker and Volk 1986]; [Graillat et al. 2009]; [de Dinechin et al. 2013]; bound derived here"};
  static constexpr LaneRegisters lanes{.per_axis = 0, .shared = 6, .one_curve_only = true};

  static constexpr std::array guarantees{
      Guarantee{Property::ends_exact},       Guarantee{Property::constant_reproduced},
      Guarantee{Property::in_hull},          Guarantee{Property::monotone},
      Guarantee{Property::reversal},         Guarantee{Property::scaling_by_two},
      Guarantee{Property::axes_independent}, Guarantee{Property::finite}};

  template <class Scalar, int Dimension, int Degree>
  using Prepared = RoundedState<Form::bernstein, Scalar, Dimension, Degree>;

  template <class Scalar, int Dimension, int Degree>
  static Prepared<Scalar, Dimension, Degree> prepare(const Curve<Form::bernstein, Scalar, Dimension, Degree>& curve) {
    const int n = curve.degree();
    const auto binomial = binomial_pairs<Scalar, Degree>(n);
    Prepared<Scalar, Dimension, Degree> prepared(n);
    prepared.given = curve;
    prepared.scaled = curve;
    for (int axis = 0; axis < Dimension; ++axis)
      prepared.rounding[static_cast<std::size_t>(axis)] = scale_axis(prepared.scaled, axis, pair_factor(n));
    for (int i = 0; i <= n; ++i)
      for (int axis = 0; axis < Dimension; ++axis) {
        const Scalar b = prepared.scaled(axis, i);
        const auto scaled = two_prod<Scalar>(binomial.high[i], b);
        prepared.scaled(axis, i) = scaled.value;
        prepared.lost(axis, i) = scaled.error + binomial.low[i] * b;
      }
    return prepared;
  }

  /// The least 1-t at which the sum begins at the start: a power of two, at most 1/2, whose n-th power is in range with
  /// the errors of a pair. At 1/2 the choice would fall differently at every other t.
  template <class Number>
  static Number min_one_minus_t(int n) {
    constexpr int bits = sizeof(Number) == sizeof(float) ? 64 : 800;
    const int exponent = std::max(1, bits / std::max(n, 1));
    return static_cast<Number>(std::bit_cast<double>(static_cast<std::uint64_t>(1023 - exponent) << 52));
  }

  /// Product of two pairs, to first order.
  template <class Scalar>
  static Expansion2<Scalar> product(const Expansion2<Scalar>& a, const Expansion2<Scalar>& b) {
    const auto value = two_prod<Scalar>(a.value, b.value);
    return {value.value, fused<Scalar>(a.value, b.error, fused<Scalar>(a.error, b.value, value.error))};
  }

  template <class Scalar>
  static Expansion2<Scalar> power(const Expansion2<Scalar>& base, int exponent) {
    return power_by_squaring<Expansion2<Scalar>>(base, exponent, {Scalar(1), Scalar(0)}, product<Scalar>);
  }

  /// The numerator over the denominator, which may have an error part.
  template <class Scalar>
  static Expansion2<Scalar> quotient(const Scalar& numerator, const Expansion2<Scalar>& denominator) {
    const Scalar value = numerator / denominator.value;
    const Scalar inverse = Scalar(1) / denominator.value;
    const Scalar remainder = fused<Scalar>(-value, denominator.value, numerator);
    return {value, fused<Scalar>(-value, denominator.error, remainder) * inverse};
  }

  /// Horner's scheme on `Count` axes; `of(curve, axis, i)` is coefficient i, counted from the end where the sum begins.
  template <int First, int Count, class Scalar, int Dimension, class Coefficients, class Of>
  static void horner(const Coefficients& coefficients, const Expansion2<Scalar>& ratio, const Of& of,
                     Pairs<Scalar, Dimension>& sums) {
    const int n = coefficients.scaled.degree();
    Scalar value[Count];
    Scalar error[Count];
    for (int k = 0; k < Count; ++k) {
      value[k] = of(coefficients.scaled, First + k, n);
      error[k] = of(coefficients.lost, First + k, n);
    }
    for (int i = n - 1; i >= 0; --i)
      for (int k = 0; k < Count; ++k) {
        const Scalar correction = fused<Scalar>(value[k], ratio.error, of(coefficients.lost, First + k, i));
        horner_step<Scalar>(value[k], error[k], ratio.value, of(coefficients.scaled, First + k, i), correction);
      }
    for (std::size_t k = 0; k < Count; ++k) sums[First + k] = {value[k], error[k]};
  }

  /// The pairs of all axes; `Coefficients` has members scaled and lost.
  template <int Dimension, class Coefficients, class Scalar>
  static Pairs<Scalar, Dimension> pairs(const Coefficients& coefficients, const Scalar& t) {
    const int n = coefficients.scaled.degree();
    const auto s = two_sum<Scalar>(Scalar(1), -t);
    const auto from_start = Scalar(min_one_minus_t<typename NumberOf<Scalar>::Type>(n)) <= s.value;
    const Expansion2<Scalar> base{select(from_start, s.value, t), s.error};
    const auto ratio = quotient<Scalar>(select(from_start, t, s.value), base);
    const auto scale = power<Scalar>(base, n);
    Pairs<Scalar, Dimension> sums;
    if (all_of(from_start))
      each_range_of_axes<Scalar, Dimension>([&]<int First, int Count>() {
        const auto coefficient = [](const auto& curve, int axis, int i) { return curve(axis, i); };
        horner<First, Count, Scalar, Dimension>(coefficients, ratio, coefficient, sums);
      });
    else
      each_range_of_axes<Scalar, Dimension>([&]<int First, int Count>() {
        const auto coefficient = [&](const auto& curve, int axis, int i) {
          return FromNearerEnd(from_start, curve)(axis, i);
        };
        horner<First, Count, Scalar, Dimension>(coefficients, ratio, coefficient, sums);
      });
    for (auto& sum : sums) sum = product(sum, scale);
    return sums;
  }

  template <class State, class Scalar>
  static auto evaluate(const State& prepared, Scalar t) {
    return rounded_point<CorrectlyRounded>(prepared, t);
  }
};

}  // namespace bezierbench
