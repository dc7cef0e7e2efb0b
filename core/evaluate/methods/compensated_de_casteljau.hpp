// SPDX-License-Identifier: MIT
// Formula: p = v_0 + ... + v_(K-1), where v_0 is de Casteljau's rounded triangle and each further one the triangle of
//   the errors of the one before: of 1-t, of the products and of the sums (compensated_triangle.hpp); K = 2, 3 and 4.
// Bound: u |p| + c_2 u^2 p~ for K = 2, else (u + 3 gamma_(K-1)^2) |p| + (c_K + a_K) u^K p~ with a_3 = 64, a_4 = 1296,
//   to first order, for any t; compensated_triangle.hpp derives it. K = 2 implies u |p| + 2 gamma_3n^2 p~
//   ([Jiang et al. 2010], Theorem 5, for n >= 2 in [0,1]). (3K - 1) n products may underflow, by eta each.
// Fails: past a condition number of 1/u^(K-1) it loses digits again, at 1/u^K all of them. Where u^K p~ < eta (p~ below
//   about 4e-292, 4e-276 and 3e-260; in float 7e-24 for K = 3, 1e-16 for K = 4) the last part underflows: for K = 2 the
//   method is no better than de Casteljau, for the others the bound is void. Its cost is quadratic.
#pragma once

#include "core/evaluate/schemes/compensated_triangle.hpp"

namespace bezierbench {

template <int K>
struct KFoldDeCasteljau : TakenAsGiven<Form::bernstein> {
  static constexpr MethodInfo info{
      .id = detail::for_parts<K>("compensated_de_casteljau", "compensated_de_casteljau_k3",
                                 "compensated_de_casteljau_k4"),
      .label = detail::for_parts<K>("de Casteljau, compensated", "de Casteljau, 3-fold", "de Casteljau, 4-fold"),
      .form = Form::bernstein,
      .bound = compensated_bound<K>(detail::for_parts<K>(
          "u p~ + c_2 u^2 p~, c_2 = 9 C(n,2) + 15 n; below u p~ + 2 gamma_3n^2 p~",
          "(u + 12 u^2) p~ + (c_3 + 64) u^3 p~, c_3 = 27 C(n,3) + 135 C(n,2) + 150 n",
          "(u + 27 u^2) p~ + (c_4 + 1296) u^4 p~, c_4 = 81 C(n,4) + 810 C(n,3) + 2475 C(n,2) + 2250 n")),
      .fused = true,
      .flops = detail::for_parts<K>("18d n(n+1)/2 + 7d + 6", "59d n(n+1)/2 + 26d + 6", "130d n(n+1)/2 + 57d + 6"),
      .cost_exponent = 2,
      .citation = K == 2 ? "[Jiang et al. 2010], Theorem 5" : "[Hermes 2019], Algorithm 4.2 and section 4.2"};
  static constexpr LaneRegisters lanes{.per_axis = 0, .shared = K == 2 ? 12 : 16};

  /// Beyond, its steps take longer than the loops around them.
  static constexpr int largest_fixed_degree = K == 2 ? 3 : 1;

  template <class Scalar, int Dimension, int Degree>
  static Point<Scalar, Dimension> evaluate(const Curve<Form::bernstein, Scalar, Dimension, Degree>& curve, Scalar t) {
    return run_compensated_triangle<K>(curve, t);
  }
};

using CompensatedDeCasteljau = KFoldDeCasteljau<2>;
using CompensatedDeCasteljauK3 = KFoldDeCasteljau<3>;
using CompensatedDeCasteljauK4 = KFoldDeCasteljau<4>;

}  // namespace bezierbench
