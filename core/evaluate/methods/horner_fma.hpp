// SPDX-License-Identifier: MIT
// Formula: p = q_n; p = fma(p, t, q_j) for j = n-1..0.
// Bound: gamma_n sum |q_j| |t|^j: one rounding a step, and q_j passes at most n of them; each may underflow.
// Fails: as any power form, when its coefficients came out of a rounded conversion.
#pragma once

#include "core/error_free.hpp"
#include "core/evaluate/evaluator.hpp"
#include "core/evaluate/schemes/steps.hpp"

namespace bezierbench {

struct HornerFma : TakenAsGiven<Form::power> {
  static constexpr MethodInfo info{.id = "horner_fma",
                                   .label = "Horner, fused",
                                   .form = Form::power,
                                   .bound = ErrorBound{.text = "gamma_n p~",
                                                       .amplification = Amplification::p_tilde_power,
                                                       .factor = [](int n, double u) { return gamma_over_u(n, u); },
                                                       .underflow = [](int n) { return 1.0 * n; },
                                                       .growth = [](int n) { return n + 1.0; },
                                                       .constant_roundings = 1},
                                   .fused = true,
                                   .flops = "dn",
                                   .citation = "[Higham 2002], section 5.1, with fused steps"};
  static constexpr LaneRegisters lanes{.per_axis = 1, .shared = 1};

  template <class Scalar, int Dimension, int Degree>
  static Point<Scalar, Dimension> evaluate(const Curve<Form::power, Scalar, Dimension, Degree>& curve, Scalar t) {
    const int n = curve.degree();
    Point<Scalar, Dimension> p;
    for (int axis = 0; axis < Dimension; ++axis) p[axis] = curve(axis, n);
    count_down<Scalar, Degree>(n - 1, [&](int j) {
      for (int axis = 0; axis < Dimension; ++axis) p[axis] = fused<Scalar>(p[axis], t, curve(axis, j));
    });
    return p;
  }
};

}  // namespace bezierbench
