// SPDX-License-Identifier: MIT
// Formula: p(t) = sum q_j t^j with t^j as a running product, added in ascending order.
// Bound: gamma_(n+1) sum |q_j| |t|^j: term j >= 1 has j-1 roundings in t^j, 1 product and at most n-j+1 additions. A
//   t^j that underflows loses up to |q_j| eta.
// Fails: as any power form, when its coefficients came out of a rounded conversion.
#pragma once

#include "core/evaluate/evaluator.hpp"
#include "core/evaluate/schemes/steps.hpp"

namespace bezierbench {

struct PowerSum : TakenAsGiven<Form::power> {
  static constexpr MethodInfo info{.id = "power_sum",
                                   .label = "Power sum, running t^j",
                                   .form = Form::power,
                                   .bound = ErrorBound{.text = "gamma_(n+1) p~",
                                                       .amplification = Amplification::p_tilde_power,
                                                       .factor = [](int n, double u) { return gamma_over_u(n + 1, u); },
                                                       .underflow = [](int n) { return 2.0 * (n + 1) * (n + 1); },
                                                       .underflow_scales_with_coefficients = true,
                                                       .growth = [](int n) { return n + 1.0; }},
                                   .flops = "n + 2dn",
                                   .citation = "[Report 001], section 1.3"};
  static constexpr LaneRegisters lanes{.per_axis = 1, .shared = 2};

  template <class Scalar, int Dimension, int Degree>
  static Point<Scalar, Dimension> evaluate(const Curve<Form::power, Scalar, Dimension, Degree>& curve, Scalar t) {
    const int n = curve.degree();
    Point<Scalar, Dimension> sum;
    for (int axis = 0; axis < Dimension; ++axis) sum[axis] = curve(axis, 0);
    Scalar t_power = Scalar(1);
    count_down<Scalar, Degree>(n - 1, [&](int left) {
      t_power *= t;
      for (int axis = 0; axis < Dimension; ++axis) sum[axis] += curve.from_end(axis, left) * t_power;
    });
    return sum;
  }
};

}  // namespace bezierbench
