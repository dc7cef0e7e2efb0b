// SPDX-License-Identifier: MIT
// Formula: p = v_0 + v_1 + v_2: Horner's rounded scheme, a scheme of its errors, and a scheme of the errors
//   of that one (compensated_horner_parts.hpp with K = 3).
// Source: [Hermes 2019], Algorithm 4.2, for Horner's scheme; the accuracy is that of [Cameron and Graillat 2024].
// Cost: 26dn + 26d flops per point, products by fused multiply-add.
// Bound: (u + 3 gamma_2^2) |p| + (c_3 + 64) u^3 p~ to first order, c_3 = 8 C(n+1,3) + 12 C(n+1,2);
//   compensated_horner_parts.hpp derives it. 3n products may underflow, by eta each.
// Fails: past a condition number of 1/u^2 it loses digits again. Where u^3 p~ < eta the bound is void, because the
//   third part underflows. Coefficients that a rounded conversion made keep their error.
#pragma once

#include "core/evaluate/schemes/compensated_horner_parts.hpp"

namespace bezierbench {

struct CompensatedHornerK3 : TakenAsGiven<Form::power> {
  static constexpr MethodInfo info{
      .id = "compensated_horner_k3",
      .label = "Horner, 3-fold",
      .problem = Problem::evaluation,
      .form = Form::power,
      .bound = compensated_horner_bound<3>("(u + 12 u^2) p~ + (c_3 + 64) u^3 p~, c_3 = 8 C(n+1,3) + 12 C(n+1,2)"),
      .flops = "26dn + 26d",
      .citation = "[Hermes 2019], Algorithm 4.2, for Horner's scheme; [Cameron and Graillat 2024]"};

  static constexpr int largest_fixed_degree = -1;  ///< its steps take longer than the loop around them

  template <class Scalar, int Dimension, int Degree>
  static Point<Scalar, Dimension> evaluate(const Curve<Form::power, Scalar, Dimension, Degree>& curve, Scalar t) {
    return run_compensated_horner<3>(curve, t);
  }
};

}  // namespace bezierbench
