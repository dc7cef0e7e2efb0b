// SPDX-License-Identifier: MIT
// Formula: p(t) = sum d_i N_i^n(t), with N_0^0 = 1 and, for r = 1..n and i = 0..r,
//     N_i^r = (t - u_(n-r+i-1)) / (u_(n+i-1) - u_(n-r+i-1)) N_(i-1)^(r-1)
//           + (u_(n+i) - t) / (u_(n+i) - u_(n-r+i)) N_i^(r-1), without the term of an N that does not exist.
// Cost: the flops without d do not depend on the control points.
// Bound: gamma_(6n+1) p~. A basis function has five roundings a level (`basis_functions`), a term of the sum one for
//   its product and up to n for the additions. Underflow: each of the 2r weights of level r has an error of at most
//   eta/2, times N_i^(r-1), whose sum is 1, and each of its 2r products one of eta/2: over all levels n(n+3)/2 eta,
//   times max|d|. The products of the last sum add (n+1) eta/2.
// Fails: no failure is known. Differences of knots that overflow are halved (`knot_weights`).
#pragma once

#include "core/bspline/bspline.hpp"

namespace bezierbench {

struct DeBoorCoxBasis {
  static constexpr BsplineBound bound{.text = "gamma_(6n+1) p~",
                                      .point = {.factor = [](int n, double u) { return gamma_over_u(6.0 * n + 1, u); },
                                                .underflow = [](int n) { return (n + 1.0) * (n + 2.0); }}};
  static constexpr MethodInfo info{.id = "de_boor_cox_basis",
                                   .label = "Basis functions of de Boor and Cox",
                                   .problem = Problem::bspline,
                                   .form = Form::bernstein,
                                   .min_degree = 1,
                                   .promise = bound.text,
                                   .flops = "4n(n+1) + d (2n + 1)",
                                   .cost_exponent = 2,
                                   .citation = "[Piegl and Tiller 1997], algorithm A2.2; bound derived here"};

  template <class Scalar, int Dimension>
  static Point<Scalar, Dimension> evaluate(const BsplineSpan<Scalar, Dimension>& span, const Scalar& t) {
    const auto basis = basis_functions(span, t);
    Point<Scalar, Dimension> point;
    for (int axis = 0; axis < Dimension; ++axis) {
      Scalar sum = basis[0] * span.control_points(axis, 0);
      for (int i = 1; i <= span.degree(); ++i) sum = sum + basis[i] * span.control_points(axis, i);
      point[axis] = sum;
    }
    return point;
  }
};

}  // namespace bezierbench
