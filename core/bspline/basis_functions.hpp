// SPDX-License-Identifier: MIT
// The basis functions of a B-spline curve that are not zero in a knot span, at one t of it, by the recurrence of de
// Boor and Cox: N_i of degree r is the sum of those of degree r - 1 to its left and right, weighted with the distances
// of t from the ends of their supports.
//
// Every path has five roundings a level, three of a weight, a product and a sum; all weights are >= 0 between a and c.
#pragma once

#include "core/bspline/bspline.hpp"
#include "core/bspline/knot_weights.hpp"

namespace bezierbench {

/// N_0(t), ..., N_n(t), in the order of the control points.
template <class Scalar, int Dimension>
PerCoefficient<Scalar, dynamic> basis_functions(const BsplineSpan<Scalar, Dimension>& span, const Scalar& t) {
  const int n = span.degree();
  auto basis = per_coefficient<Scalar, dynamic>(n);
  basis[0] = Scalar(1);
  for (int r = 1; r <= n; ++r) {
    Scalar carried(0);
    for (int i = 0; i < r; ++i) {
      const auto weights = knot_weights(span.knot(n - r + i), span.knot(n + i), t);
      const Scalar lower = basis[i];
      basis[i] = carried + weights.left * lower;
      carried = weights.right * lower;
    }
    basis[r] = carried;
  }
  return basis;
}

}  // namespace bezierbench
