// SPDX-License-Identifier: MIT
// Formula: h_0 = 1, Q_0 = b_0; h_k = (n-k+1) t h_(k-1) / (k (1-t) + (n-k+1) t h_(k-1)); Q_k = (1-h_k) Q_(k-1) + h_k
//   b_k; p = Q_n. Of t and 1-t the larger is divided out.
// Cost: O(d) memory.
// Bound: none relative to p~: 1 - h_k cancels where h_k is near 1 (wozny_chudy_positive avoids that).
// Fails: outside [0,1] the combinations are no longer convex and a denominator may vanish.
#pragma once

#include "core/evaluate/evaluator.hpp"
#include "core/evaluate/schemes/steps.hpp"
#include "core/vector/lane_choice.hpp"

namespace bezierbench {

struct WoznyChudy : TakenAsGiven<Form::bernstein> {
  static constexpr MethodInfo info{.id = "wozny_chudy",
                                   .label = "Wozny-Chudy",
                                   .form = Form::bernstein,
                                   .one_minus_t = OneMinusT::normalised,
                                   .flops = "n(6+3d) + 3, n + 1 of them divisions",
                                   .citation = "[Wozny and Chudy 2020], Algorithm 1.1"};
  static constexpr LaneRegisters lanes{.per_axis = 0, .shared = 3};

  template <class Scalar, int Dimension, int Degree>
  static Point<Scalar, Dimension> evaluate(const Curve<Form::bernstein, Scalar, Dimension, Degree>& curve, Scalar t) {
    const int n = curve.degree();
    const Scalar s = Scalar(1) - t;
    const auto near_start = t + t <= Scalar(1);
    const Scalar ratio = select(near_start, t, s) / select(near_start, s, t);
    const Scalar t_share = select(near_start, ratio, Scalar(1));  // the pair t : 1-t, over the larger of them
    const Scalar rest_share = select(near_start, Scalar(1), ratio);
    Point<Scalar, Dimension> q;
    for (int axis = 0; axis < Dimension; ++axis) q[axis] = curve(axis, 0);
    Scalar h = Scalar(1);
    count_down<Scalar, Degree>(n - 1, [&](int left) {
      const int k = n - left;
      const Scalar numerator = h * t_share * static_cast<Scalar>(left + 1);
      h = numerator / (static_cast<Scalar>(k) * rest_share + numerator);
      const Scalar rest = Scalar(1) - h;
      for (int axis = 0; axis < Dimension; ++axis) q[axis] = rest * q[axis] + h * curve.from_end(axis, left);
    });
    return q;
  }
};

}  // namespace bezierbench
