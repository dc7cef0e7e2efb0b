// SPDX-License-Identifier: MIT
// de Casteljau with the errors of 1-t, of the products and of the sums carried through a second triangle, and added.
//
// Source: Jiang, Li, Cheng and Su, Computers & Mathematics with Applications 60 (2010) 744-755.
// Cost: 18 d n(n+1)/2 + 7d + 6 flops per point, products by fused multiply-add.
// Bound: u |p| + c_2 u^2 p~ with c_2 = 3n(3n+7)/2 to first order, for any t; derived in compensated_triangle.hpp. It
//   implies u |p| + 2 gamma_3n^2 p~ (Jiang et al., Theorem 5, for n >= 2 in [0,1]). 5n products may underflow, by eta
//   each.
// Fails: past a condition number of 1/u digits are lost again, at 1/u^2 all; where u^2 p~ < eta (p~ below about 4e-292)
//   it is no better than de Casteljau; quadratic cost.
#pragma once

#include "core/evaluate/compensated_triangle.hpp"

namespace bezierbench {

struct CompensatedDeCasteljau {
  static constexpr MethodInfo info{
      .id = "compensated_de_casteljau",
      .label = "de Casteljau, compensated",
      .problem = Problem::evaluation,
      .form = Form::bernstein,
      .bound = compensated_bound<2>("u p~ + c_2 u^2 p~, c_2 = 9 C(n,2) + 15 n; below u p~ + 2 gamma_3n^2 p~"),
      .flops = "18d n(n+1)/2 + 7d + 6",
      .cost_exponent = 2,
      .citation = "Jiang, Li, Cheng and Su 2010, Theorem 5"};

  template <class Scalar, int Dimension, int Degree>
  static Curve<Form::bernstein, Scalar, Dimension, Degree> prepare(
      const Curve<Form::bernstein, Scalar, Dimension, Degree>& curve) {
    return curve;
  }

  template <class Scalar, int Dimension, int Degree>
  static Point<Scalar, Dimension> evaluate(const Curve<Form::bernstein, Scalar, Dimension, Degree>& curve, Scalar t) {
    return run_compensated_triangle<2>(curve, t);
  }
};

}  // namespace bezierbench
