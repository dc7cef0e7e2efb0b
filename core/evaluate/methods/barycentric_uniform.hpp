// SPDX-License-Identifier: MIT
// Formula: the second barycentric form (barycentric.hpp) with uniform nodes, x_j = j/n, j = 0..n.
// Weights: (-1)^j C(n,j) over the largest of them ([Berrut and Trefethen 2004], eq. (5.1)), up to the rounding of the
//   nodes.
// Bound: (4n+7) u L max|b| on [0,1], to first order and while (2n+2) u L < 1 (barycentric.hpp). The Lebesgue constant L
//   is below 2^n and close to 2^(n+1)/(e n ln n). It is not a multiple of p~, so `info` states none.
// Fails: at high degree, through L: half of the digits are lost at n = 34, all at n = 62. In float 1/C(n,n/2) is
//   subnormal past n = 129.
#pragma once

#include "core/evaluate/schemes/barycentric.hpp"

namespace bezierbench {

struct BarycentricUniform {
  static constexpr MethodInfo info{.id = "barycentric_uniform",
                                   .label = "Barycentric, uniform nodes",
                                   .form = Form::bernstein,
                                   .max_degree_float = 129,
                                   .flops = "(n+1)(3+2d) + d, n+1+d of them divisions",
                                   .prepare_exponent = 2,
                                   .citation =
                                       "[Berrut and Trefethen 2004], eq. (4.2); [Fuda et al. 2024], "
                                       "UNI"};
  static constexpr LaneRegisters lanes{.per_axis = 1, .shared = 2, .one_curve_only = true};

  static constexpr int largest_fixed_degree = 2;  ///< beyond, its division takes longer than the loop around it

  template <class Scalar, int Dimension, int Degree>
  static Barycentric<Scalar, Dimension, Degree> prepare(
      const Curve<Form::bernstein, Scalar, Dimension, Degree>& curve) {
    const int n = curve.degree();
    return prepare_barycentric(curve, detail::mirrored_nodes<Scalar, Degree>(n, [n](int j) {
                                 using Wide = detail::PerCurve<Scalar>;
                                 return Wide(Wide(j) / Wide(n));
                               }));
  }

  template <class Scalar, int Dimension, int Degree>
  static Point<Scalar, Dimension> evaluate(const Barycentric<Scalar, Dimension, Degree>& prepared, Scalar t) {
    return evaluate_barycentric(prepared, t);
  }
};

}  // namespace bezierbench
