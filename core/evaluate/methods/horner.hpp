// SPDX-License-Identifier: MIT
// Formula: p = q_n; p = p t + q_j for j = n-1..0.
// Source: [Horner 1819].
// Bound: gamma_2n sum |q_j| |t|^j ([Higham 2002], eq. 5.3); n products may underflow, by eta/2 each.
// Fails: as any power form, when its coefficients came out of a rounded conversion.
#pragma once

#include "core/evaluate/evaluator.hpp"
#include "core/evaluate/schemes/steps.hpp"

namespace bezierbench {

struct Horner : TakenAsGiven<Form::power> {
  static constexpr MethodInfo info{.id = "horner",
                                   .label = "Horner",
                                   .form = Form::power,
                                   .bound = ErrorBound{.text = "gamma_2n p~",
                                                       .amplification = Amplification::p_tilde_power,
                                                       .factor = [](int n, double u) { return gamma_over_u(2 * n, u); },
                                                       .underflow = [](int n) { return 1.0 * n; },
                                                       .growth = [](int n) { return n + 1.0; },
                                                       .constant_roundings = 1},
                                   .flops = "2dn",
                                   .citation = "[Higham 2002], section 5.1"};
  static constexpr LaneRegisters lanes{.per_axis = 1, .shared = 1};

  template <class Scalar, int Dimension, int Degree>
  static Point<Scalar, Dimension> evaluate(const Curve<Form::power, Scalar, Dimension, Degree>& curve, Scalar t) {
    const int n = curve.degree();
    Point<Scalar, Dimension> p;
    for (int axis = 0; axis < Dimension; ++axis) p[axis] = curve(axis, n);
    count_down<Scalar, Degree>(n - 1, [&](int j) {
      for (int axis = 0; axis < Dimension; ++axis) p[axis] = p[axis] * t + curve(axis, j);
    });
    return p;
  }
};

}  // namespace bezierbench
