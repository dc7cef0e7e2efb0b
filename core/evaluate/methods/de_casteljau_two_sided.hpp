// SPDX-License-Identifier: MIT
// Formula: b_i^k = a + t (b - a) for t <= 1/2, b + (1-t) (a - b) else, with a = b_i^(k-1), b = b_(i+1)^(k-1);
//   p(t) = b_0^n. The interpolation starts from the end that t is nearer to.
// Bound: gamma_3n p~ for t <= 2, else gamma_4n p~: three roundings a level; for t > 2, 1-t is rounded as well.
// Keeps: ends_exact, constant_reproduced, in_hull, monotone for n = 1, and what all variants keep:
//   docs/proofs/de_casteljau.md.
// Fails: b - a, up to 2 max|b|, can overflow although the result does not.
#pragma once

#include "core/evaluate/guarantee.hpp"
#include "core/evaluate/schemes/nearer_end.hpp"
#include "core/evaluate/schemes/triangle.hpp"

namespace bezierbench {

struct DeCasteljauTwoSided : TakenAsGiven<Form::bernstein> {
  static constexpr MethodInfo info{.id = "de_casteljau_two_sided",
                                   .label = "de Casteljau, two-sided",
                                   .form = Form::bernstein,
                                   .bound = ErrorBound{.text = "gamma_4n p~ (gamma_3n for t <= 2)",
                                                       .amplification = Amplification::p_tilde_bernstein,
                                                       .factor = [](int n, double u) { return gamma_over_u(4 * n, u); },
                                                       .underflow = [](int n) { return 1.0 * n; },
                                                       .growth = [](int) { return 2.0; }},
                                   .flops = "3d n(n+1)/2 + 2",
                                   .cost_exponent = 2,
                                   .citation = "[Farin 2002], with two-sided linear interpolation; bound derived here"};
  static constexpr LaneRegisters lanes{.per_axis = 0, .shared = 6};

  static constexpr std::array guarantees{Guarantee{Property::ends_exact},     Guarantee{Property::constant_reproduced},
                                         Guarantee{Property::in_hull},        Guarantee{Property::monotone, 1},
                                         Guarantee{Property::scaling_by_two}, Guarantee{Property::axes_independent},
                                         Guarantee{Property::total}};

  template <class Scalar, int Dimension, int Degree>
  static Point<Scalar, Dimension> evaluate(const Curve<Form::bernstein, Scalar, Dimension, Degree>& curve, Scalar t) {
    const auto near_start = t + t <= Scalar(1);
    const Scalar r = select(near_start, t, Scalar(1) - t);
    return run_triangle(FromNearerEnd(near_start, curve), [r](Scalar a, Scalar b) { return a + r * (b - a); });
  }
};

}  // namespace bezierbench
