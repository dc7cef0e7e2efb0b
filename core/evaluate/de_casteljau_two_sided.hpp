// SPDX-License-Identifier: MIT
// Formula: b_i^k = a + t (b - a) for t <= 1/2, b + (1-t) (a - b) else, with a = b_i^(k-1), b = b_(i+1)^(k-1);
//   p(t) = b_0^n. The interpolation starts from the end that t is nearer to.
// Source: [Farin 2002], the de Casteljau algorithm, with linear interpolation in its two-sided form; the bound is
//   derived here.
// Cost: 3 d n(n+1)/2 + 1 flops per point.
// Bound: gamma_3n p~ for t <= 2, else gamma_4n p~. Take t <= 1/2, where |t| <= |1-t|. The difference and the product
//   perturb t (b - a) by at most gamma_2 |t| (|a| + |b|) <= gamma_2 (|1-t||a| + |t||b|), and the sum rounds once: three
//   roundings a level. For t > 1/2 the same holds with the ends exchanged, and 1-t is exact up to t = 2 (Sterbenz);
//   beyond, its rounding is a fourth.
// Keeps: ends_exact, constant_reproduced: t or 1-t is 0, or b - a is. in_hull: let d be the rounded b - a >= 0, and
//   r <= 1/2. Where b - a is exact, fl(r d) <= d = b - a, because fl is monotone and keeps d. Else d / 2 is exact, and
//   fl(r d) <= d / 2 <= (b - a) (1 + u) / 2. So a + fl(r d) lies in [a, b] and its rounding, too; likewise for b < a.
//   monotone for n = 1: on each side of 1/2 as in de_casteljau_lerp. Between them it has to be shown for d > 0 that
//   b_0 + fl(d/2) <= b_1 - fl(r d) for r = 1-t <= 1/2 - u. Let g be the last place of d. Where d / 2 is exact and
//   normal, d misses b_1 - b_0 by at most g/2, and r d <= d/2 - u d <= d/2 - g/2, which is a number; so
//   b_1 - fl(r d) >= b_0 + (d - g/2) - (d/2 - g/2). Else d = k eta = b_1 - b_0. For even k both products are at most
//   d/2, for odd k fl(d/2) is at most (k+1)/2 eta and fl(r d), of less than k/2 eta, at most (k-1)/2 eta. The rest in
//   triangle_scheme.hpp.
// Fails: b - a, up to 2 max|b|, can overflow although the result does not.
#pragma once

#include "core/evaluate/guarantee.hpp"
#include "core/evaluate/nearer_end.hpp"
#include "core/evaluate/triangle_scheme.hpp"

namespace bezierbench {

struct DeCasteljauTwoSided : TakenAsGiven<Form::bernstein> {
  static constexpr MethodInfo info{.id = "de_casteljau_two_sided",
                                   .label = "de Casteljau, two-sided",
                                   .problem = Problem::evaluation,
                                   .form = Form::bernstein,
                                   .bound = ErrorBound{.text = "gamma_4n p~ (gamma_3n for t <= 2)",
                                                       .amplification = Amplification::p_tilde_bernstein,
                                                       .factor = [](int n, double u) { return gamma_over_u(4 * n, u); },
                                                       .underflow = [](int n) { return 1.0 * n; },
                                                       .underflow_scales_with_coefficients = false,
                                                       .growth = [](int) { return 2.0; }},
                                   .flops = "3d n(n+1)/2 + 1",
                                   .cost_exponent = 2,
                                   .citation = "[Farin 2002], with two-sided linear interpolation; bound derived here"};

  static constexpr std::array guarantees{Guarantee{Property::ends_exact},     Guarantee{Property::constant_reproduced},
                                         Guarantee{Property::in_hull},        Guarantee{Property::monotone, 1},
                                         Guarantee{Property::scaling_by_two}, Guarantee{Property::axes_independent},
                                         Guarantee{Property::total}};

  template <class Scalar, int Dimension, int Degree>
  static Point<Scalar, Dimension> evaluate(const Curve<Form::bernstein, Scalar, Dimension, Degree>& curve, Scalar t) {
    const auto near_start = t + t <= Scalar(1);
    const Scalar r = select(near_start, t, Scalar(1) - t);
    return run_triangle(seen(near_start, curve), [r](Scalar a, Scalar b) { return a + r * (b - a); });
  }
};

}  // namespace bezierbench
