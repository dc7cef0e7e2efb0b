// SPDX-License-Identifier: MIT
// Formula: b_i^k = fma(t, b - a, a) with a = b_i^(k-1), b = b_(i+1)^(k-1); p(t) = b_0^n.
// Bound: none relative to p~: where |a| is far larger than the result, p~ does not cover the rounding of b - a.
// Keeps: constant_reproduced: b - a is 0. monotone for n = 1: b_0 + t d is rounded once, and rounding is monotone. The
//   rest: docs/proofs/de_casteljau.md.
// Fails: it misses the end point b_n at t = 1. b - a can overflow although the result does not.
#pragma once

#include "core/error_free.hpp"
#include "core/evaluate/guarantee.hpp"
#include "core/evaluate/schemes/triangle.hpp"

namespace bezierbench {

struct DeCasteljauLerpFma : TakenAsGiven<Form::bernstein> {
  static constexpr MethodInfo info{.id = "de_casteljau_lerp_fma",
                                   .label = "de Casteljau, a + t(b - a), fused",
                                   .form = Form::bernstein,
                                   .fused = true,
                                   .flops = "d n(n+1)",
                                   .cost_exponent = 2,
                                   .citation = "[Document 004], with fused linear interpolation"};
  static constexpr LaneRegisters lanes{.per_axis = 0, .shared = 6, .largest_fixed_degree = 12};

  static constexpr int largest_fixed_degree = 20;  ///< two operations a step: sweeps would take up to 1.4 times as long

  static constexpr std::array guarantees{Guarantee{Property::constant_reproduced}, Guarantee{Property::monotone, 1},
                                         Guarantee{Property::scaling_by_two}, Guarantee{Property::axes_independent},
                                         Guarantee{Property::total}};

  template <class Scalar, int Dimension, int Degree>
  static Point<Scalar, Dimension> evaluate(const Curve<Form::bernstein, Scalar, Dimension, Degree>& curve, Scalar t) {
    return run_triangle(curve, [t](Scalar a, Scalar b) { return fused<Scalar>(t, b - a, a); });
  }
};

}  // namespace bezierbench
