// SPDX-License-Identifier: MIT
// Formula: the double nearest to p, ties to even, infinite where p is too large. First compensated Horner, a pair
//   value + error; where its bound leaves two numbers to choose from, the same with the bound in terms of p~; then
//   exact integers (correctly_rounded_integers.hpp).
// Cost: the flops are those where the pair decides. The integers take microseconds at n = 20.
// Bound: u |p|, and eta/2 where the result is subnormal: it is correctly rounded. The bound of the pair, e = 2 (q + k)
//   u^2 sum |q_j|, follows as in correctly_rounded.hpp, without errors of ratio and coefficients: a step adds 2 u A to
//   the error part, which is at most k u A with k = 2j after j of n + 1 steps, and misses (3 + 2 + k) u^2 A, for the
//   fused part of two_sum, the sum of both parts and the last fused step. All steps: q = 5 (n+1) + (n+1) (n+2).
// Fails: where a curve is subnormal or p cancels to below 2^-38 sum |q_j|, each point takes microseconds. t outside
//   [0,1] is outside its domain and gives NaN.
#pragma once

#include "core/evaluate/methods/correctly_rounded.hpp"

namespace bezierbench {

struct CorrectlyRoundedPower {
  /// e / (u^2 sum |q_j|), and the same for p~ in place of the sum.
  static constexpr double pair_factor(int n) {
    const double steps = n + 1;
    return 2 * (5 * steps + steps * (steps + 1) + 2 * steps);
  }

  static constexpr MethodInfo info{.id = "correctly_rounded",
                                   .label = "correctly rounded",
                                   .form = Form::power,
                                   .max_degree = rounded_max_degree,
                                   .max_degree_float = CorrectlyRounded::info.max_degree_float,
                                   .unit_interval_only = true,
                                   .bound = ErrorBound{.text = "u p~ on [0,1]",
                                                       .amplification = Amplification::p_tilde_power,
                                                       .factor = CorrectlyRounded::info.bound->factor,
                                                       .underflow = CorrectlyRounded::info.bound->underflow,
                                                       .growth = [](int n) { return n + 1.0; },
                                                       .unit_interval_only = true,
                                                       .result_roundings = 1},
                                   .fused = true,
                                   .flops = "9dn + 5d",
                                   .citation = "[Graillat et al. 2009]; [de Dinechin et al. 2013]; bound derived here"};
  static constexpr LaneRegisters lanes{.per_axis = 0, .shared = 5, .one_curve_only = true};

  template <class Scalar, int Dimension, int Degree>
  using Prepared = RoundedState<Form::power, Scalar, Dimension, Degree>;

  template <class Scalar, int Dimension, int Degree>
  static Prepared<Scalar, Dimension, Degree> prepare(const Curve<Form::power, Scalar, Dimension, Degree>& curve) {
    Prepared<Scalar, Dimension, Degree> prepared(curve.degree());
    prepared.given = curve;
    prepared.scaled = curve;
    for (int axis = 0; axis < Dimension; ++axis)
      prepared.rounding[static_cast<std::size_t>(axis)] =
          scale_axis(prepared.scaled, axis, pair_factor(curve.degree()));
    return prepared;
  }

  /// The pairs of all axes; `Coefficients` has a member scaled.
  template <int Dimension, class Coefficients, class Scalar>
  static Pairs<Scalar, Dimension> pairs(const Coefficients& coefficients, const Scalar& t) {
    const int n = coefficients.scaled.degree();
    Pairs<Scalar, Dimension> sums;
    each_range_of_axes<Scalar, Dimension>([&]<int First, int Count>() {
      Scalar value[Count];
      Scalar error[Count];
      for (int k = 0; k < Count; ++k) {
        value[k] = coefficients.scaled(First + k, n);
        error[k] = Scalar(0);
      }
      for (int j = n - 1; j >= 0; --j)
        for (int k = 0; k < Count; ++k)
          horner_step<Scalar>(value[k], error[k], t, coefficients.scaled(First + k, j), Scalar(0));
      for (std::size_t k = 0; k < Count; ++k) sums[First + k] = {value[k], error[k]};
    });
    return sums;
  }

  template <class State, class Scalar>
  static auto evaluate(const State& prepared, Scalar t) {
    return rounded_point<CorrectlyRoundedPower>(prepared, t);
  }
};

}  // namespace bezierbench
