// SPDX-License-Identifier: MIT
// Formula: b_i^k = (1-t) b_i^(k-1) + t b_(i+1)^(k-1); left_k = b_0^k, right_(n-k) = b_(n-k)^k: both halves from one
//   triangle.
// Bound: a level costs at most three roundings (1-t, product, sum) and its weights are positive, so by induction a
//   point of k levels is off by at most gamma_3k sum |b_j| B_j,k(t) on [0,1]. Two products a level may underflow, by
//   eta/2 each, and what follows magnifies that by less than 2: 2k eta.
// Fails: does not reproduce constants; the rounding of 1-t makes small t three times worse than t near 1.
#pragma once

#include "core/subdivide/subdivision.hpp"

namespace bezierbench {

struct DeCasteljauSplit {
  static constexpr SplitBound bound{.text = "gamma_3k p~ of a control point of k levels",
                                    .amplification = SplitAmplification::p_tilde,
                                    .factor = [](int k, double u) { return gamma_over_u(3 * k, u); },
                                    .underflow = [](int k) { return 2.0 * k; }};
  static constexpr SplitPromises promises{.keeps_ends = true,
                                          .shares_junction = true,
                                          .exact_at_zero = true,
                                          .exact_at_one = true,
                                          .reproduces_constants = false,
                                          .mirrors = true};
  static constexpr MethodInfo info{.id = "de_casteljau_split",
                                   .label = "de Casteljau",
                                   .problem = Problem::subdivision,
                                   .form = Form::bernstein,
                                   .promise = bound.text,
                                   .one_minus_t = OneMinusT::summed,
                                   .flops = "3d n(n+1)/2 + 1",
                                   .cost_exponent = 2,
                                   .citation = "[Farin 2002], subdivision"};

  template <class Scalar, int Dimension, int Degree>
  static Halves<Curve<Form::bernstein, Scalar, Dimension, Degree>> split(
      const Curve<Form::bernstein, Scalar, Dimension, Degree>& curve, Scalar t) {
    const Scalar s = Scalar(1) - t;
    return split_by_triangle(curve, [s, t](Scalar a, Scalar b) { return s * a + t * b; });
  }
};

}  // namespace bezierbench
