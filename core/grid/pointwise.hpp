// SPDX-License-Identifier: MIT
// Formula: an evaluator at each t_k = k/m by itself: what a method on grids has to be faster than, and is less accurate
//   than.
// Cost: the evaluator's and one product for t_k.
// Bound: the evaluator's in [0, 1], at every k the same.
// Fails: where the evaluator does.
#pragma once

#include "core/evaluate/evaluator.hpp"
#include "core/evaluate/joined.hpp"
#include "core/grid/grid.hpp"
#include "core/powers.hpp"

namespace bezierbench {

template <Evaluator E>
struct Pointwise {
  static_assert(E::info.bound->result_roundings == 0);

  static constexpr GridBound bound{
      .text = E::info.bound->text,
      .amplification = E::info.bound->amplification,
      .factor = [](int n, int /*k*/, double u) { return E::info.bound->factor(n, u); },
      .underflow = [](int n, int /*steps*/) { return E::info.bound->underflow(n); },
      .underflow_scales_with_coefficients = E::info.bound->underflow_scales_with_coefficients,
      .growth = [](int n, int /*steps*/) { return E::info.bound->growth(n); }};
  static constexpr MethodInfo info{.id = detail::Joined<detail::Literal<"pointwise_">, detail::IdOf<E>>::text,
                                   .label = E::info.label,
                                   .problem = Problem::grid,
                                   .form = E::info.form,
                                   .max_degree = E::info.max_degree,
                                   .promise = bound.text,
                                   .bit_stable = E::info.bit_stable,
                                   .flops = E::info.flops,
                                   .cost_exponent = E::info.cost_exponent,
                                   .prepare_exponent = E::info.prepare_exponent,
                                   .citation = E::info.citation};

  template <int Dimension>
  struct Prepared {
    PreparedOf<E, double, Dimension> curve;
    int steps;
  };

  template <int Dimension>
  static Prepared<Dimension> prepare(const Curve<E::info.form, double, Dimension>& curve, int steps) {
    return {E::prepare(curve), steps};
  }

  template <int Dimension, class Take>
  static void run(const Prepared<Dimension>& prepared, Take take) {
    const double width = 1.0 / prepared.steps;
    for (int k = 0; k <= prepared.steps; ++k) take(k, E::evaluate(prepared.curve, k * width));
  }
};

}  // namespace bezierbench
