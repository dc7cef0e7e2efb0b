// SPDX-License-Identifier: MIT
// Formula: p = v_0 + v_1, where v_0 is de Casteljau's rounded triangle and v_1 a second triangle, which carries the
//   errors of 1-t, of the products and of the sums (compensated_triangle.hpp with K = 2).
// Source: [Jiang et al. 2010].
// Cost: 18 d n(n+1)/2 + 7d + 6 flops per point, products by fused multiply-add.
// Bound: u |p| + c_2 u^2 p~ with c_2 = 3n(3n+7)/2 to first order, for any t; compensated_triangle.hpp derives it. It
//   implies u |p| + 2 gamma_3n^2 p~ ([Jiang et al. 2010], Theorem 5, for n >= 2 in [0,1]). 5n products may underflow,
//   by eta each.
// Fails: past a condition number of 1/u it loses digits again, at 1/u^2 all of them. Where u^2 p~ < eta (p~ below about
//   4e-292) it is no better than de Casteljau. Its cost is quadratic.
#pragma once

#include "core/evaluate/schemes/compensated_triangle.hpp"

namespace bezierbench {

struct CompensatedDeCasteljau : TakenAsGiven<Form::bernstein> {
  static constexpr MethodInfo info{
      .id = "compensated_de_casteljau",
      .label = "de Casteljau, compensated",
      .problem = Problem::evaluation,
      .form = Form::bernstein,
      .bound = compensated_bound<2>("u p~ + c_2 u^2 p~, c_2 = 9 C(n,2) + 15 n; below u p~ + 2 gamma_3n^2 p~"),
      .flops = "18d n(n+1)/2 + 7d + 6",
      .cost_exponent = 2,
      .citation = "[Jiang et al. 2010], Theorem 5"};

  static constexpr int largest_fixed_degree = 3;  ///< beyond, its steps take longer than the loops around them

  template <class Scalar, int Dimension, int Degree>
  static Point<Scalar, Dimension> evaluate(const Curve<Form::bernstein, Scalar, Dimension, Degree>& curve, Scalar t) {
    return run_compensated_triangle<2>(curve, t);
  }
};

}  // namespace bezierbench
