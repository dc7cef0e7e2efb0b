// SPDX-License-Identifier: MIT
// Formula: p = v_0 + v_1 + v_2: de Casteljau's rounded triangle, a triangle of its errors, and a triangle of the errors
//   of that one (compensated_triangle.hpp with K = 3).
// Source: [Hermes 2019], Algorithm 4.2 with K = 3.
// Cost: 59 d n(n+1)/2 + 26d + 6 flops per point, products by fused multiply-add.
// Bound: (u + 3 gamma_2^2) |p| + (c_3 + 64) u^3 p~ to first order, c_3 = 27 C(n,3) + 135 C(n,2) + 150 n;
//   compensated_triangle.hpp derives it. 8n products may underflow, by eta each.
// Fails: past a condition number of 1/u^2 it loses digits again. Where u^3 p~ < eta (p~ below about 4e-276, in float
//   7e-24) the bound is void, because the third part underflows. Its cost is quadratic.
#pragma once

#include "core/evaluate/schemes/compensated_triangle.hpp"

namespace bezierbench {

struct CompensatedDeCasteljauK3 : TakenAsGiven<Form::bernstein> {
  static constexpr MethodInfo info{
      .id = "compensated_de_casteljau_k3",
      .label = "de Casteljau, 3-fold",
      .problem = Problem::evaluation,
      .form = Form::bernstein,
      .bound = compensated_bound<3>("(u + 12 u^2) p~ + (c_3 + 64) u^3 p~, c_3 = 27 C(n,3) + 135 C(n,2) + 150 n"),
      .flops = "59d n(n+1)/2 + 26d + 6",
      .cost_exponent = 2,
      .citation = "[Hermes 2019], Algorithm 4.2 and section 4.2"};

  static constexpr int largest_fixed_degree = 1;  ///< beyond, its steps take longer than the loops around them

  template <class Scalar, int Dimension, int Degree>
  static Point<Scalar, Dimension> evaluate(const Curve<Form::bernstein, Scalar, Dimension, Degree>& curve, Scalar t) {
    return run_compensated_triangle<3>(curve, t);
  }
};

}  // namespace bezierbench
