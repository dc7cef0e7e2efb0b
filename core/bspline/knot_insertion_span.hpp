// SPDX-License-Identifier: MIT
// Formula: a is inserted until its multiplicity is n, then c, from the last control point on; levels r = 1..n-1:
//     d_i = ((u_(i+n) - a) d_i + (a - u_(i+r-1)) d_(i+1)) / (u_(i+n) - u_(i+r-1)) for i = 0..n-1-r
//     d_i = ((u_(i+n-r) - c) d_(i-1) + (c - a) d_i) / (u_(i+n-r) - a) for i = n..r+1.
//   Now d_i is the blossom at n-i times a and i times c: the control points b_i of the span. Points by the triangle
//   over b_i (`point_of_span`).
// Cost: for the control points (3d + 5) n(n-1) flops.
// Bound: gamma_10(n-1) sum |d_i| c_i of a control point, gamma_(15n-10) p~ of a point. A path to a control point passes
//   at most n-1 levels for each end, of five roundings, and one to a point n more. All weights are >= 0, since a and c
//   lie between the two knots of each weight. Underflow as for de_boor, for as many levels.
// Fails: no failure is known. Differences of knots that overflow are halved (`knot_weights`).
#pragma once

#include "core/bspline/bspline.hpp"

namespace bezierbench {

struct KnotInsertionSpan {
  static constexpr BsplineBound bound{
      .text = "gamma_(15n-10) p~, control points gamma_10(n-1)",
      .point = {
          .factor = [](int n, double u) { return gamma_over_u(10.0 * (n - 1) + roundings_of_point_of_span(n), u); },
          .underflow = [](int n) { return 6.0 * n; }},
      .control = BsplineBound::Part{.factor = [](int n, double u) { return gamma_over_u(10.0 * (n - 1), u); },
                                    .underflow = [](int n) { return 4.0 * (n - 1); }}};
  static constexpr MethodInfo info{.id = "knot_insertion_span",
                                   .label = "Bernstein form by knot insertion",
                                   .problem = Problem::bspline,
                                   .form = Form::bernstein,
                                   .min_degree = 1,
                                   .promise = bound.text,
                                   .flops = "3d n(n+1)/2 + 5",
                                   .cost_exponent = 2,
                                   .prepare_exponent = 2,
                                   .citation = "[Boehm 1980]; [Ramshaw 1987]; bound derived here"};

  template <class Scalar, int Dimension>
  static Curve<Form::bernstein, Scalar, Dimension> convert(const BsplineSpan<Scalar, Dimension>& span) {
    const int n = span.degree();
    const Scalar& a = span.begin();
    const Scalar& c = span.end();
    auto d = span.control_points;
    for (int r = 1; r < n; ++r)
      for (int i = 0; i < n - r; ++i) step_between(knot_weights(span.knot(i + r - 1), span.knot(i + n), a), i, i, d);
    for (int r = 1; r < n; ++r)
      for (int i = n; i > r; --i) step_between(knot_weights(a, span.knot(i + n - r), c), i - 1, i, d);
    return d;
  }
};

}  // namespace bezierbench
