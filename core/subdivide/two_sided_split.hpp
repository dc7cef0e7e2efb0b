// SPDX-License-Identifier: MIT
// Formula: b_i^k = a + t (b - a) for t <= 1/2, b + (1-t) (a - b) else: anchored at the nearer end; left_k = b_0^k,
//   right_(n-k) = b_(n-k)^k.
// Bound: take t <= 1/2, so t <= 1-t. With d the rounding of the sum, the result is a (1 + d) + t (b - a) (1 +
//   theta_3) and off by at most |a| ((1-t) u + t gamma_2 (1 + u)) + t |b| gamma_3 <= gamma_3 ((1-t) |a| + t |b|): a
//   point of k levels by gamma_3k sum |b_j| B_j,k(t). For 1/2 < t <= 1 the same holds with the ends exchanged, for
//   1-t is exact there (Sterbenz). One product a level may underflow, by eta/2, magnified by less than 2: k eta.
// Fails: b - a can overflow although the result does not; at t = 1/2 both ends are equally near and the start is
//   taken, so there the curve run backwards may have halves with other bits.
#pragma once

#include "core/evaluate/schemes/nearer_end.hpp"
#include "core/subdivide/subdivision.hpp"

namespace bezierbench {

struct TwoSidedSplit {
  static constexpr SplitBound bound{.text = "gamma_3k p~ of a control point of k levels",
                                    .amplification = SplitAmplification::p_tilde,
                                    .factor = [](int k, double u) { return gamma_over_u(3 * k, u); },
                                    .underflow = [](int k) { return 1.0 * k; },
                                    .growth = 2};
  static constexpr SplitPromises promises{.keeps_ends = true,
                                          .shares_junction = true,
                                          .exact_at_zero = true,
                                          .exact_at_one = true,
                                          .reproduces_constants = true,
                                          .mirrors = false};
  static constexpr MethodInfo info{
      .id = "two_sided_split",
      .label = "de Casteljau, two-sided",
      .problem = Problem::subdivision,
      .form = Form::bernstein,
      .promise = bound.text,
      .flops = "3d n(n+1)/2 + 1",
      .cost_exponent = 2,
      .citation = "[Farin 2002], subdivision, with two-sided linear interpolation; bound derived here"};

  template <class Scalar, int Dimension, int Degree>
  static Halves<Curve<Form::bernstein, Scalar, Dimension, Degree>> split(
      const Curve<Form::bernstein, Scalar, Dimension, Degree>& curve, Scalar t) {
    const bool near_start = t + t <= Scalar(1);
    const Scalar r = near_start ? t : Scalar(1) - t;
    const auto step = [r](Scalar a, Scalar b) { return a + r * (b - a); };
    if (near_start) return split_by_triangle(curve, step);
    const auto from_end = split_by_triangle(reversed(curve), step);
    return {reversed(from_end.right), reversed(from_end.left)};
  }
};

}  // namespace bezierbench
