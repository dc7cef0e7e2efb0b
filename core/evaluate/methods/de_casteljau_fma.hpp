// SPDX-License-Identifier: MIT
// Formula: b_i^k = fma(t, b, fma(-t, a, a)) with a = b_i^(k-1), b = b_(i+1)^(k-1); p(t) = b_0^n.
// Bound: gamma_2n p~: a - t a is (1-t) a rounded once, with 1-t never formed, and the outer operation rounds once more.
//   Each of the two may underflow, by eta/2.
// Keeps: ends_exact: at t = 0 a step is 0 b + (a - 0 a) = a, at t = 1 it is 1 b + (a - a) = b. finite: let W be the
//   largest number and q its last place; sums round to infinity from W + q/2 on. The inner operation gives (1-t) a + e
//   with its rounding e, for a >= 0 say, and the exact outer sum is at most t W + (1-t) a + e. Below the binade of W
//   the inner result has e <= q/4. In that binade e <= q/2, and W + q/2 is reached only for a = W and e = q/2: then
//   (1-t) (2^p - 1), for the precision p, is an odd multiple of 1/2; since 2^p - 1 is odd, t = 1/2, and (1-t) W is
//   exact. The rest: docs/proofs/de_casteljau.md.
// Fails: its cost is quadratic. It is slow where fused multiply-add is emulated.
#pragma once

#include "core/error_free.hpp"
#include "core/evaluate/guarantee.hpp"
#include "core/evaluate/schemes/triangle.hpp"

namespace bezierbench {

struct DeCasteljauFma : TakenAsGiven<Form::bernstein> {
  static constexpr MethodInfo info{.id = "de_casteljau_fma",
                                   .label = "de Casteljau, fused",
                                   .form = Form::bernstein,
                                   .bound = ErrorBound{.text = "gamma_2n p~",
                                                       .amplification = Amplification::p_tilde_bernstein,
                                                       .factor = [](int n, double u) { return gamma_over_u(2 * n, u); },
                                                       .underflow = [](int n) { return 2.0 * n; }},
                                   .fused = true,
                                   .flops = "d n(n+1)",
                                   .cost_exponent = 2,
                                   .citation = "[Farin 2002], with fused linear interpolation; bound derived here"};
  static constexpr LaneRegisters lanes{.per_axis = 0, .shared = 6};

  static constexpr std::array guarantees{Guarantee{Property::ends_exact}, Guarantee{Property::finite},
                                         Guarantee{Property::scaling_by_two}, Guarantee{Property::axes_independent},
                                         Guarantee{Property::total}};

  template <class Scalar, int Dimension, int Degree>
  static Point<Scalar, Dimension> evaluate(const Curve<Form::bernstein, Scalar, Dimension, Degree>& curve, Scalar t) {
    return run_triangle(curve, [t](Scalar a, Scalar b) { return fused<Scalar>(t, b, fused<Scalar>(-t, a, a)); });
  }
};

}  // namespace bezierbench
