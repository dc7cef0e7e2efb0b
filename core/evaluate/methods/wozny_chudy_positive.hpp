// SPDX-License-Identifier: MIT
// Formula: as wozny_chudy, with both weights as quotients of the same denominator D = k (1-t) + (n-k+1) t h, h =
//   h_(k-1): Q_k = (k (1-t)/D) Q_(k-1) + ((n-k+1) t h/D) b_k. Nothing is subtracted.
// Cost: O(d) memory.
// Bound: gamma_((3n+2)(n+1)) p~ for 0 <= t <= 1; wozny_chudy_weights.hpp derives it.
// Fails: outside [0,1] the combinations are no longer convex and a denominator may vanish.
#pragma once

#include "core/bound/amplification.hpp"
#include "core/evaluate/evaluator.hpp"
#include "core/evaluate/schemes/wozny_chudy_weights.hpp"

namespace bezierbench {

struct WoznyChudyPositive : TakenAsGiven<Form::bernstein> {
  static constexpr MethodInfo info{
      .id = "wozny_chudy_positive",
      .label = "Wozny-Chudy, subtraction-free",
      .form = Form::bernstein,
      .bound = ErrorBound{.text = "gamma_((3n+2)(n+1)) p~ on [0,1]",
                          .amplification = Amplification::p_tilde_bernstein,
                          .factor = [](int n, double u) { return gamma_over_u((3.0 * n + 2) * (n + 1), u); },
                          .underflow = [](int n) { return 4.0 * (n + 1) * (n + 1) * integer_power(2.0, n); },
                          .underflow_scales_with_coefficients = true,
                          .unit_interval_only = true},
      .one_minus_t = OneMinusT::normalised,
      .flops = "n(6+3d) + 3, 2n + 1 of them divisions",
      .citation = "[Wozny and Chudy 2020], remark on the weights"};
  static constexpr LaneRegisters lanes{.per_axis = 0, .shared = 3};

  template <class Scalar, int Dimension, int Degree>
  static Point<Scalar, Dimension> evaluate(const Curve<Form::bernstein, Scalar, Dimension, Degree>& curve, Scalar t) {
    const int n = curve.degree();
    WoznyChudyWeights<Scalar> weights(n, t);
    Point<Scalar, Dimension> q;
    for (int axis = 0; axis < Dimension; ++axis) q[axis] = curve(axis, 0);
    for (int k = 1; k <= n; ++k) {
      const auto weight = weights.next(k);
      for (int axis = 0; axis < Dimension; ++axis) q[axis] = weight.point * q[axis] + weight.control * curve(axis, k);
    }
    return q;
  }
};

}  // namespace bezierbench
