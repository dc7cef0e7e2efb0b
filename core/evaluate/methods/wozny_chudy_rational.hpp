// SPDX-License-Identifier: MIT
// Formula: h_0 = 1, Q_0 = b_0; h_k = r_k t h_(k-1) / ((1-t) + r_k t h_(k-1)) with r_k = (n-k+1) w_k / (k w_(k-1)) from
//   `prepare`; Q_k = (1-h_k) Q_(k-1) + h_k b_k; p = Q_n. Of t and 1-t the larger is divided out.
// Cost: O(d) memory; per curve 4n.
// Bound: none relative to p~: 1 - h_k cancels where h_k is near 1 (wozny_chudy_positive avoids that).
// Fails: a weight of 0 between others makes 0/0. Outside [0,1] or with weights of both signs a denominator may vanish.
#pragma once

#include <tuple>

#include "core/evaluate/evaluator.hpp"
#include "core/evaluate/schemes/steps.hpp"
#include "core/vector/lane_choice.hpp"

namespace bezierbench {

struct WoznyChudyRational {
  static constexpr MethodInfo info{.id = "wozny_chudy",
                                   .label = "Wozny-Chudy, rational",
                                   .form = Form::rational,
                                   .one_minus_t = OneMinusT::normalised,
                                   .flops = "n(5+3d) + 3, n + 1 of them divisions",
                                   .citation = "[Wozny and Chudy 2020], rational curves"};
  static constexpr LaneRegisters lanes{.per_axis = 0, .shared = 3, .one_curve_only = true};

  static constexpr int largest_fixed_degree = 3;  ///< beyond, its steps take longer than the loop around them

  template <class Scalar, int Dimension, int Degree>
  struct Prepared {
    Curve<Form::bernstein, Scalar, Dimension, Degree> points;
    PreparedRow<Scalar, Degree> ratios;  ///< r_k at index k; index 0 is unused

    [[nodiscard]] auto parts() const { return std::tie(points, ratios); }
  };

  template <class Scalar, int Dimension, int Degree>
  static Prepared<Scalar, Dimension, Degree> prepare(const Curve<Form::rational, Scalar, Dimension, Degree>& curve) {
    const int n = curve.degree();
    Prepared<Scalar, Dimension, Degree> prepared{working_copy(curve.points), per_coefficient<Scalar, Degree>(n)};
    for (int k = 1; k <= n; ++k)
      prepared.ratios[k] =
          (static_cast<Scalar>(n - k + 1) * curve.weights[k]) / (static_cast<Scalar>(k) * curve.weights[k - 1]);
    return prepared;
  }

  template <class Scalar, int Dimension, int Degree>
  static Point<Scalar, Dimension> evaluate(const Prepared<Scalar, Dimension, Degree>& prepared, Scalar t) {
    const int n = prepared.points.degree();
    const Scalar s = Scalar(1) - t;
    const auto near_start = t + t <= Scalar(1);
    const Scalar ratio = select(near_start, t, s) / select(near_start, s, t);
    const Scalar t_share = select(near_start, ratio, Scalar(1));  // the pair t : 1-t, over the larger of them
    const Scalar complement = select(near_start, Scalar(1), ratio);
    Point<Scalar, Dimension> q;
    for (int axis = 0; axis < Dimension; ++axis) q[axis] = prepared.points(axis, 0);
    Scalar h = Scalar(1);
    count_down<Scalar, Degree>(n - 1, [&](int left) {
      const int k = n - left;
      const Scalar numerator = h * (t_share * prepared.ratios[k]);
      h = numerator / (complement + numerator);
      const Scalar rest = Scalar(1) - h;
      for (int axis = 0; axis < Dimension; ++axis) q[axis] = rest * q[axis] + h * prepared.points.from_end(axis, left);
    });
    return q;
  }
};

}  // namespace bezierbench
