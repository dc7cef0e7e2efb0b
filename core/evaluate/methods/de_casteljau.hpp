// SPDX-License-Identifier: MIT
// Formula: b_i^k = (1-t) b_i^(k-1) + t b_(i+1)^(k-1), p(t) = b_0^n.
// Source: [de Casteljau 1959].
// Bound: gamma_3n p~: a level costs at most three roundings (1-t, product, sum); gamma_2n p~ where 1-t is exact. Two
//   products a level may underflow, by eta/2 each.
// Keeps: ends_exact, reversal, finite, and what all variants keep: docs/proofs/de_casteljau.md.
// Fails: its cost is quadratic. The rounding of 1-t makes the error at small t three times that at t near 1.
#pragma once

#include "core/evaluate/guarantee.hpp"
#include "core/evaluate/schemes/triangle.hpp"

namespace bezierbench {

struct DeCasteljau : TakenAsGiven<Form::bernstein> {
  static constexpr MethodInfo info{.id = "de_casteljau",
                                   .label = "de Casteljau",
                                   .form = Form::bernstein,
                                   .bound = ErrorBound{.text = "gamma_3n p~",
                                                       .amplification = Amplification::p_tilde_bernstein,
                                                       .factor = [](int n, double u) { return gamma_over_u(3 * n, u); },
                                                       .underflow = [](int n) { return 2.0 * n; }},
                                   .one_minus_t = OneMinusT::summed,
                                   .flops = "3d n(n+1)/2 + 1",
                                   .cost_exponent = 2,
                                   .citation = "[Farin 2002]; [Report 001], section 1.5"};
  static constexpr LaneRegisters lanes{.per_axis = 0, .shared = 6};

  static constexpr std::array guarantees{Guarantee{Property::ends_exact},       Guarantee{Property::reversal},
                                         Guarantee{Property::finite},           Guarantee{Property::scaling_by_two},
                                         Guarantee{Property::axes_independent}, Guarantee{Property::total}};

  template <class Scalar, int Dimension, int Degree>
  static Point<Scalar, Dimension> evaluate(const Curve<Form::bernstein, Scalar, Dimension, Degree>& curve, Scalar t) {
    const Scalar s = Scalar(1) - t;
    return run_triangle(curve, [s, t](Scalar a, Scalar b) { return s * a + t * b; });
  }
};

}  // namespace bezierbench
