// SPDX-License-Identifier: MIT
// Formula: d_i = ((u_(i+n) - t) d_i + (t - u_(i+r-1)) d_(i+1)) / (u_(i+n) - u_(i+r-1)) for i = 0..n-r, level r = 1..n;
//   p(t) = d_0.
// Source: here with a quotient for each weight.
// Bound: gamma_5n p~. A level multiplies a path from a control point to the result by a weight, which has three
//   roundings, and adds a product and a sum. All weights are >= 0 for t in the span, so that the paths from d_i sum to
//   N_i(t). A weight may lose eta/2 by underflow, times a point, and a product eta/2: eta (1 + max|d|) a level.
// Fails: no part of its work is kept for the next t of the same span.
#pragma once

#include "core/bspline/bspline.hpp"

namespace bezierbench {

struct DeBoor {
  static constexpr BsplineBound bound{.text = "gamma_5n p~",
                                      .point = {.factor = [](int n, double u) { return gamma_over_u(5.0 * n, u); },
                                                .underflow = [](int n) { return 2.0 * n; }}};
  static constexpr MethodInfo info{.id = "de_boor",
                                   .label = "de Boor",
                                   .problem = Problem::bspline,
                                   .form = Form::bernstein,
                                   .min_degree = 1,
                                   .promise = bound.text,
                                   .flops = "(3d + 5) n(n+1)/2",
                                   .cost_exponent = 2,
                                   .citation = "[de Boor 1978], chapter X; bound derived here"};

  template <class Scalar, int Dimension>
  static Point<Scalar, Dimension> evaluate(const BsplineSpan<Scalar, Dimension>& span, const Scalar& t) {
    const int n = span.degree();
    auto d = span.control_points;
    for (int r = 1; r <= n; ++r)
      for (int i = 0; i <= n - r; ++i) step_between(knot_weights(span.knot(i + r - 1), span.knot(i + n), t), i, i, d);
    Point<Scalar, Dimension> point;
    for (int axis = 0; axis < Dimension; ++axis) point[axis] = d(axis, 0);
    return point;
  }
};

}  // namespace bezierbench
