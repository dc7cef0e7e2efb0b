// SPDX-License-Identifier: MIT
// Formula: p = v_0 + v_1 + v_2 + v_3: de Casteljau's rounded triangle and three triangles, each of the errors of the
//   one before (compensated_triangle.hpp with K = 4).
// Source: [Hermes 2019], Algorithm 4.2 with K = 4.
// Cost: 130 d n(n+1)/2 + 57d + 6 flops per point, products by fused multiply-add.
// Bound: (u + 3 gamma_3^2) |p| + (c_4 + 1296) u^4 p~ to first order, c_4 = 81 C(n,4) + 810 C(n,3) + 2475 C(n,2) +
//   2250 n; compensated_triangle.hpp derives it. 11n products may underflow, by eta each.
// Fails: past a condition number of 1/u^3 it loses digits again. Where u^4 p~ < eta (p~ below about 3e-260, in float
//   1e-16) the bound is void, because the fourth part underflows. Its cost is quadratic.
#pragma once

#include "core/evaluate/schemes/compensated_triangle.hpp"

namespace bezierbench {

struct CompensatedDeCasteljauK4 : TakenAsGiven<Form::bernstein> {
  static constexpr MethodInfo info{
      .id = "compensated_de_casteljau_k4",
      .label = "de Casteljau, 4-fold",
      .problem = Problem::evaluation,
      .form = Form::bernstein,
      .bound = compensated_bound<4>(
          "(u + 27 u^2) p~ + (c_4 + 1296) u^4 p~, c_4 = 81 C(n,4) + 810 C(n,3) + 2475 C(n,2) + 2250 n"),
      .flops = "130d n(n+1)/2 + 57d + 6",
      .cost_exponent = 2,
      .citation = "[Hermes 2019], Algorithm 4.2 and section 4.2"};

  static constexpr int largest_fixed_degree = 1;  ///< beyond, its steps take longer than the loops around them

  template <class Scalar, int Dimension, int Degree>
  static Point<Scalar, Dimension> evaluate(const Curve<Form::bernstein, Scalar, Dimension, Degree>& curve, Scalar t) {
    return run_compensated_triangle<4>(curve, t);
  }
};

}  // namespace bezierbench
