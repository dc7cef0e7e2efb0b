// SPDX-License-Identifier: MIT
// Formula: roots of f = (C - P).C' / n in Bernstein form, degree 2n-1, isolated by Descartes' rule on halved pieces of
//   the curve:
//     f_k = sum_(i+j=k) C(n,i) C(n-1,j) / C(2n-1,k) (b_i - P).(b_(j+1) - b_j),
//   then Newton's method: on the f_k of the piece while the steps are long, on (C - P).C' from the control points for
//   the last steps, most often one. A root at which f falls is counted only: the distance is largest there. The curve
//   and its differences are halved, not f: near the point they are small, and so are the rounding errors of f.
// Source: products in Bernstein form by [Farouki and Rajan 1988].
// Cost: most often 2 to 10 pieces. Quadratics and cubics run in code of their own degree, without allocation.
// Bound: polished_residual_bound of (C - P).C' at t inside (0, 1). A running bound of every rounding error says which
//   signs of the f_k are certain. A piece is dropped only if no choice of the uncertain signs allows a root. A piece
//   all of whose signs are uncertain, where the distance is constant up to rounding, gives one candidate, from which
//   the distance is minimised further.
// Fails: above degree 512 the binomials of degree 2n-1 overflow.
#pragma once

#include "core/project/isolation.hpp"

namespace bezierbench {

struct QuinticIsolate {
  static constexpr MethodInfo info{.id = "quintic_isolate",
                                   .label = "Roots isolated in Bernstein form, Newton",
                                   .problem = Problem::projection,
                                   .form = Form::bernstein,
                                   .min_degree = 1,
                                   .max_degree = 512,
                                   .promise = "no point of the curve is nearer, to rounding",
                                   .flops = "O(d n^2) per piece and per Newton step",
                                   .cost_exponent = 2,
                                   .citation = "[Chen et al. 2007]; [Lane and Riesenfeld 1981]"};
  static constexpr auto residual_bound = polished_residual_bound;

  template <int Dimension>
  static FootPoint project(const Curve<Form::bernstein, double, Dimension>& curve,
                           const Point<double, Dimension>& point) {
    switch (curve.degree()) {
      case 2: return Isolation<Dimension, 2>(curve, point).foot();
      case 3: return Isolation<Dimension, 3>(curve, point).foot();
      default: return Isolation<Dimension>(curve, point).foot();
    }
  }
};

}  // namespace bezierbench
