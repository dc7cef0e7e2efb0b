// SPDX-License-Identifier: MIT
// Formula: p = v_0 + v_1 + v_2 + v_3: Horner's rounded scheme and three schemes, each of the errors of the one
//   before (compensated_horner_parts.hpp with K = 4).
// Source: [Hermes 2019], Algorithm 4.2, for Horner's scheme; the accuracy is that of [Cameron and Graillat 2024].
// Cost: 47dn + 57d flops per point, products by fused multiply-add.
// Bound: (u + 3 gamma_3^2) |p| + (c_4 + 1296) u^4 p~ to first order, c_4 = 16 C(n+1,4) + 56 C(n+1,3) + 48
//   C(n+1,2); compensated_horner_parts.hpp derives it. 4n products may underflow, by eta each.
// Fails: past a condition number of 1/u^3 it loses digits again. Where u^4 p~ < eta the bound is void, because the
//   fourth part underflows. Coefficients that a rounded conversion made keep their error.
#pragma once

#include "core/evaluate/schemes/compensated_horner_parts.hpp"

namespace bezierbench {

struct CompensatedHornerK4 : TakenAsGiven<Form::power> {
  static constexpr MethodInfo info{
      .id = "compensated_horner_k4",
      .label = "Horner, 4-fold",
      .problem = Problem::evaluation,
      .form = Form::power,
      .bound = compensated_horner_bound<4>(
          "(u + 27 u^2) p~ + (c_4 + 1296) u^4 p~, c_4 = 16 C(n+1,4) + 56 C(n+1,3) + 48 C(n+1,2)"),
      .flops = "47dn + 57d",
      .citation = "[Hermes 2019], Algorithm 4.2, for Horner's scheme; [Cameron and Graillat 2024]"};

  static constexpr int largest_fixed_degree = -1;  ///< its steps take longer than the loop around them

  template <class Scalar, int Dimension, int Degree>
  static Point<Scalar, Dimension> evaluate(const Curve<Form::power, Scalar, Dimension, Degree>& curve, Scalar t) {
    return run_compensated_horner<4>(curve, t);
  }
};

}  // namespace bezierbench
