// SPDX-License-Identifier: MIT
// Formula: p = v_0 + ... + v_(K-1), where v_0 is Horner's rounded scheme and each further one a scheme of the errors of
//   the one before (compensated_horner_parts.hpp); K = 3 and 4.
// Bound: (u + 3 gamma_(K-1)^2) |p| + (c_K + a_K) u^K p~ to first order, with a_3 = 64 and a_4 = 1296;
//   compensated_horner_parts.hpp derives it. K n products may underflow, by eta each.
// Fails: past a condition number of 1/u^(K-1) it loses digits again. Where u^K p~ < eta the bound is void, because the
//   last part underflows. Coefficients that a rounded conversion made keep their error.
#pragma once

#include "core/evaluate/schemes/compensated_horner_parts.hpp"

namespace bezierbench {

template <int K>
struct KFoldHorner : TakenAsGiven<Form::power> {
  static constexpr MethodInfo info{
      .id = K == 3 ? "compensated_horner_k3" : "compensated_horner_k4",
      .label = K == 3 ? "Horner, 3-fold" : "Horner, 4-fold",
      .form = Form::power,
      .bound = compensated_horner_bound<K>(
          K == 3 ? "(u + 12 u^2) p~ + (c_3 + 64) u^3 p~, c_3 = 8 C(n+1,3) + 12 C(n+1,2)"
                 : "(u + 27 u^2) p~ + (c_4 + 1296) u^4 p~, c_4 = 16 C(n+1,4) + 56 C(n+1,3) + 48 C(n+1,2)"),
      .fused = true,
      .flops = K == 3 ? "26dn + 26d" : "47dn + 57d",
      .citation = "[Hermes 2019], Algorithm 4.2, for Horner's scheme; [Cameron and Graillat 2024]"};
  static constexpr LaneRegisters lanes{.per_axis = 0, .shared = K == 3 ? 9 : 12};

  static constexpr int largest_fixed_degree = -1;  ///< its steps take longer than the loop around them

  template <class Scalar, int Dimension, int Degree>
  static Point<Scalar, Dimension> evaluate(const Curve<Form::power, Scalar, Dimension, Degree>& curve, Scalar t) {
    return run_compensated_horner<K>(curve, t);
  }
};

using CompensatedHornerK3 = KFoldHorner<3>;
using CompensatedHornerK4 = KFoldHorner<4>;

}  // namespace bezierbench
