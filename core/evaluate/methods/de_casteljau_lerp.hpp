// SPDX-License-Identifier: MIT
// Formula: b_i^k = a + t (b - a) with a = b_i^(k-1), b = b_(i+1)^(k-1); p(t) = b_0^n.
// Source: the `lerp` of graphics libraries interpolates in this way, too.
// Bound: none relative to p~: where |a| is far larger than the result, p~ does not cover the rounding of b - a.
// Keeps: constant_reproduced: b - a is 0. monotone for n = 1: b_0 + t (b_1 - b_0) rounds three times, each time a
//   monotone function of t. The rest: docs/proofs/de_casteljau.md.
// Fails: it misses the end point b_n at t = 1. b - a can overflow although the result does not.
#pragma once

#include "core/evaluate/guarantee.hpp"
#include "core/evaluate/schemes/triangle.hpp"

namespace bezierbench {

struct DeCasteljauLerp : TakenAsGiven<Form::bernstein> {
  static constexpr MethodInfo info{.id = "de_casteljau_lerp",
                                   .label = "de Casteljau, a + t(b - a)",
                                   .form = Form::bernstein,
                                   .flops = "3d n(n+1)/2",
                                   .cost_exponent = 2,
                                   .citation = "[Document 004]"};
  static constexpr LaneRegisters lanes{.per_axis = 0, .shared = 6};

  static constexpr std::array guarantees{Guarantee{Property::constant_reproduced}, Guarantee{Property::monotone, 1},
                                         Guarantee{Property::scaling_by_two}, Guarantee{Property::axes_independent},
                                         Guarantee{Property::total}};

  template <class Scalar, int Dimension, int Degree>
  static Point<Scalar, Dimension> evaluate(const Curve<Form::bernstein, Scalar, Dimension, Degree>& curve, Scalar t) {
    return run_triangle(curve, [t](Scalar a, Scalar b) { return a + t * (b - a); });
  }
};

}  // namespace bezierbench
