// SPDX-License-Identifier: MIT
// Formula: b_i^k = a + t (b - a) with a = b_i^(k-1), b = b_(i+1)^(k-1); left_k = b_0^k, right_(n-k) = b_(n-k)^k.
// Bound: none against p~: where |a| is far larger than the result, the rounding of b - a is not covered by it. With M
//   = max |b_j|, on [0,1]: difference and product are off by 2 M gamma_2, the sum rounds once, so a level adds at
//   most gamma_5 M to values of at most M (1 + gamma_5)^(level - 1), and k levels gamma_5k M. One product a level may
//   underflow, by eta/2, and what follows magnifies that by less than 2: k eta.
// Fails: at t = 1 left is not the curve; errors may be of the size of u max |b_j| where p~ is far smaller; b - a can
//   overflow although the result does not.
#pragma once

#include "core/subdivide/subdivision.hpp"

namespace bezierbench {

struct LerpSplit {
  static constexpr SplitBound bound{.text = "gamma_5k max|b_j| of a control point of k levels",
                                    .amplification = SplitAmplification::largest,
                                    .factor = [](int k, double u) { return gamma_over_u(5 * k, u); },
                                    .underflow = [](int k) { return 1.0 * k; },
                                    .growth = 2};
  static constexpr SplitPromises promises{.keeps_ends = true,
                                          .shares_junction = true,
                                          .exact_at_zero = true,
                                          .exact_at_one = false,
                                          .reproduces_constants = true,
                                          .mirrors = false};
  static constexpr MethodInfo info{.id = "lerp_split",
                                   .label = "de Casteljau, a + t(b - a)",
                                   .problem = Problem::subdivision,
                                   .form = Form::bernstein,
                                   .promise = bound.text,
                                   .flops = "3d n(n+1)/2",
                                   .cost_exponent = 2,
                                   .citation = "[Document 004], third answer; bound derived here"};

  template <class Scalar, int Dimension, int Degree>
  static Halves<Curve<Form::bernstein, Scalar, Dimension, Degree>> split(
      const Curve<Form::bernstein, Scalar, Dimension, Degree>& curve, Scalar t) {
    return split_by_triangle(curve, [t](Scalar a, Scalar b) { return a + t * (b - a); });
  }
};

}  // namespace bezierbench
