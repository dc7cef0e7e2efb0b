// SPDX-License-Identifier: MIT
// Formula: p = q_n; p = p s + q_j for j = n-1..0, with s = t - 1/2 and q_j the coefficients about t = 1/2.
// Bound: gamma_3n sum |q_j| |s|^j: two roundings a step by Horner's scheme, and that of s, which is exact for t in
//   [1/4, 1] (Sterbenz). n products may underflow, by eta/2 each.
// Fails: towards both ends, where a conversion amplifies by 2^n (3^n about t = 0).
#pragma once

#include "core/evaluate/evaluator.hpp"
#include "core/evaluate/schemes/steps.hpp"

namespace bezierbench {

struct HornerCentered : TakenAsGiven<Form::power_centered> {
  static constexpr MethodInfo info{.id = "horner_centered",
                                   .label = "Horner about t = 1/2",
                                   .form = Form::power_centered,
                                   .bound = ErrorBound{.text = "gamma_3n sum |q_j| |t - 1/2|^j",
                                                       .amplification = Amplification::p_tilde_centered,
                                                       .factor = [](int n, double u) { return gamma_over_u(3 * n, u); },
                                                       .underflow = [](int n) { return 1.0 * n; },
                                                       .growth = [](int n) { return n + 1.0; }},
                                   .flops = "2dn + 1",
                                   .citation = "[Higham 2002], section 5.1; bound derived here"};
  static constexpr LaneRegisters lanes{.per_axis = 1, .shared = 1};

  template <class Scalar, int Dimension, int Degree>
  static Point<Scalar, Dimension> evaluate(const Curve<Form::power_centered, Scalar, Dimension, Degree>& curve,
                                           Scalar t) {
    const int n = curve.degree();
    const Scalar s = t - Scalar(1) / Scalar(2);
    Point<Scalar, Dimension> p;
    for (int axis = 0; axis < Dimension; ++axis) p[axis] = curve(axis, n);
    count_down<Scalar, Degree>(n - 1, [&](int j) {
      for (int axis = 0; axis < Dimension; ++axis) p[axis] = p[axis] * s + curve(axis, j);
    });
    return p;
  }
};

}  // namespace bezierbench
