// SPDX-License-Identifier: MIT
// Formula: left_i = b[0^(n-i), t^i], right_i = b[t^(n-i), 1^i], b[u_1..u_n] the blossom of the curve: each new
//   control point from a triangle of its own, whose level m combines neighbours a, b to (1-u_m) a + u_m b. An
//   argument 0 keeps the first of two neighbours and an argument 1 the second, so what has to be computed is the
//   triangle at t over b_0..b_i, or over b_i..b_n.
// Bound: as for de_casteljau_split, whose operations are done again for each point: gamma_3k sum |b_j| B_j,k(t) on
//   [0,1] and 2k eta.
// Fails: its cost is cubic, although its bits are those of de_casteljau_split.
#pragma once

#include "core/subdivide/de_casteljau_split.hpp"

namespace bezierbench {

struct BlossomSplit {
  static constexpr SplitBound bound = DeCasteljauSplit::bound;
  static constexpr SplitPromises promises = DeCasteljauSplit::promises;
  static constexpr MethodInfo info{.id = "blossom_split",
                                   .label = "Blossom of each control point",
                                   .problem = Problem::subdivision,
                                   .form = Form::bernstein,
                                   .promise = bound.text,
                                   .one_minus_t = OneMinusT::summed,
                                   .flops = "d n(n+1)(n+2) + 1",
                                   .cost_exponent = 3,
                                   .citation = "[Ramshaw 1987]"};

  template <class Scalar, int Dimension, int Degree>
  static Halves<Curve<Form::bernstein, Scalar, Dimension, Degree>> split(
      const Curve<Form::bernstein, Scalar, Dimension, Degree>& curve, Scalar t) {
    const int n = curve.degree();
    const Scalar s = Scalar(1) - t;
    Halves<Curve<Form::bernstein, Scalar, Dimension, Degree>> halves{curve, curve};
    for (int i = 0; i <= n; ++i)
      for (int axis = 0; axis < Dimension; ++axis) {
        halves.left(axis, i) = blossom(curve, axis, 0, i, s, t);
        halves.right(axis, i) = blossom(curve, axis, i, n - i, s, t);
      }
    return halves;
  }

 private:
  /// The value of the blossom with `levels` arguments t, `first` arguments 1 and all others 0: the triangle over the
  /// control points first .. first + levels.
  template <class Scalar, int Dimension, int Degree>
  static Scalar blossom(const Curve<Form::bernstein, Scalar, Dimension, Degree>& curve, int axis, int first, int levels,
                        const Scalar& s, const Scalar& t) {
    auto b = per_coefficient<Scalar, dynamic>(levels);
    for (int i = 0; i <= levels; ++i) b[i] = curve(axis, first + i);
    for (int k = 1; k <= levels; ++k)
      for (int i = 0; i <= levels - k; ++i) b[i] = s * b[i] + t * b[i + 1];
    return b[0];
  }
};

}  // namespace bezierbench
