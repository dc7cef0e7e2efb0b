// SPDX-License-Identifier: MIT
// A point of a knot span from its Bernstein form: the triangle of de Casteljau with the weights (c - t) / (c - a) and
// (t - a) / (c - a), each a quotient of its own (knot_weights.hpp). So there is no rounded parameter of which 1 - t
// would be formed, and each level has five roundings: three of a weight, a product and a sum.
#pragma once

#include "core/bspline/bspline.hpp"
#include "core/bspline/knot_weights.hpp"
#include "core/evaluate/schemes/triangle_scheme.hpp"

namespace bezierbench {

/// The roundings of every path through the triangle.
constexpr int roundings_of_point_of_span(int degree) { return 5 * degree; }

template <class Scalar, int Dimension>
Point<Scalar, Dimension> point_of_span(const Curve<Form::bernstein, Scalar, Dimension>& bernstein, const Scalar& a,
                                       const Scalar& c, const Scalar& t) {
  const auto weights = knot_weights(a, c, t);
  return run_triangle(bernstein, [&weights](const Scalar& left, const Scalar& right) {
    return Scalar(weights.left * left + weights.right * right);
  });
}

}  // namespace bezierbench
