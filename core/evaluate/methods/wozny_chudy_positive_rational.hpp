// SPDX-License-Identifier: MIT
// Formula: as wozny_chudy_rational, with both weights as quotients of the same denominator D = (1-t) + r_k t h,
//   h = h_(k-1): Q_k = ((1-t)/D) Q_(k-1) + (r_k t h/D) b_k. Nothing is subtracted.
// Cost: O(d) memory; per curve 4n.
// Bound: gamma_((4.5n+2)(n+1)) p~ for weights > 0 and 0 <= t <= 1; the proof, with underflow, is in
//   docs/proofs/wozny_chudy_positive_rational.md.
// Fails: a weight of 0 between others makes 0/0. Outside [0,1] or with weights of both signs a denominator may vanish.
#pragma once

#include "core/evaluate/methods/wozny_chudy_rational.hpp"
#include "core/powers.hpp"

namespace bezierbench {

struct WoznyChudyPositiveRational {
  static constexpr MethodInfo info{
      .id = "wozny_chudy_positive",
      .label = "Wozny-Chudy, rational, subtraction-free",
      .form = Form::rational,
      .bound = ErrorBound{.text = "gamma_((4.5n+2)(n+1)) p~ for positive weights",
                          .amplification = Amplification::p_tilde_bernstein,
                          .factor = [](int n, double u) { return gamma_over_u((4.5 * n + 2) * (n + 1), u); },
                          .underflow = [](int n) { return 8.0 * (n + 1) * (n + 1) * integer_power(2.0, n); },
                          .underflow_scales_with_coefficients = true,
                          .unit_interval_only = true,
                          .positive_weights_only = true},
      .one_minus_t = OneMinusT::normalised,
      .flops = "n(5+3d) + 3, 2n + 1 of them divisions",
      .citation = "[Wozny and Chudy 2020], remark on the weights"};
  static constexpr LaneRegisters lanes{.per_axis = 0, .shared = 3, .one_curve_only = true};

  static constexpr int largest_fixed_degree = 6;  ///< beyond, its steps take longer than the loop around them

  template <class Scalar, int Dimension, int Degree>
  static auto prepare(const Curve<Form::rational, Scalar, Dimension, Degree>& curve) {
    return WoznyChudyRational::prepare(curve);
  }

  template <class Scalar, int Dimension, int Degree>
  static Point<Scalar, Dimension> evaluate(const WoznyChudyRational::Prepared<Scalar, Dimension, Degree>& prepared,
                                           Scalar t) {
    const int n = prepared.points.degree();
    const Scalar s = Scalar(1) - t;
    const auto near_start = t + t <= Scalar(1);
    const Scalar ratio = select(near_start, t, s) / select(near_start, s, t);
    const Scalar t_share = select(near_start, ratio, Scalar(1));
    const Scalar complement = select(near_start, Scalar(1), ratio);
    Point<Scalar, Dimension> q;
    for (int axis = 0; axis < Dimension; ++axis) q[axis] = prepared.points(axis, 0);
    Scalar h = Scalar(1);
    for (int k = 1; k <= n; ++k) {
      const Scalar numerator = h * (t_share * prepared.ratios[k]);
      const Scalar denominator = complement + numerator;
      h = numerator / denominator;
      const Scalar rest = complement / denominator;
      for (int axis = 0; axis < Dimension; ++axis) q[axis] = rest * q[axis] + h * prepared.points(axis, k);
    }
    return q;
  }
};

}  // namespace bezierbench
