// SPDX-License-Identifier: MIT
// b_i^k = a + t (b - a) with a = b_i^(k-1), b = b_(i+1)^(k-1); p(t) = b_0^n.
//
// Source: the linear interpolation of seed document 004; the usual `lerp` of graphics libraries.
// Cost: 3 d n(n+1)/2 flops per point.
// Bound: none against p~: where |a| is far larger than the result, the rounding of b - a is not covered by it.
// Fails: misses the end point b_n at t = 1; b - a can overflow although the result does not.
#pragma once

#include "core/evaluate/triangle_scheme.hpp"

namespace bezierbench {

struct DeCasteljauLerp {
  static constexpr MethodInfo info{.id = "de_casteljau_lerp",
                                   .label = "de Casteljau, a + t(b - a)",
                                   .problem = Problem::evaluation,
                                   .form = Form::bernstein,
                                   .flops = "3d n(n+1)/2",
                                   .cost_exponent = 2,
                                   .citation = "seed document 004"};

  template <class Scalar, int Dimension, int Degree>
  static Curve<Form::bernstein, Scalar, Dimension, Degree> prepare(
      const Curve<Form::bernstein, Scalar, Dimension, Degree>& curve) {
    return curve;
  }

  template <class Scalar, int Dimension, int Degree>
  static Point<Scalar, Dimension> evaluate(const Curve<Form::bernstein, Scalar, Dimension, Degree>& curve, Scalar t) {
    return run_triangle(curve, [t](Scalar a, Scalar b) { return a + t * (b - a); });
  }
};

}  // namespace bezierbench
