// SPDX-License-Identifier: MIT
// A curve in Bernstein form with its control points counted from the end that t is nearer to: from b_0 for t <= 1/2,
// else from b_n, where 1-t is the parameter. `select` makes the choices, so that a scalar that is a vector chooses in
// each of its lanes.
#pragma once

#include "core/evaluate/evaluator.hpp"
#include "core/vector/lane_choice.hpp"

namespace bezierbench {

/// Coefficient i of an axis from the start, or from the other end.
template <class Scalar, int Dimension, int Degree>
Scalar from_nearer_end(bool from_start, const Curve<Form::bernstein, Scalar, Dimension, Degree>& curve, int axis,
                       int i) {
  return curve(axis, from_start ? i : curve.degree() - i);
}

/// The curve, or the curve with its control points in reverse order.
template <class Scalar, int Dimension, int Degree>
Curve<Form::bernstein, Scalar, Dimension, Degree> reversed_unless(
    bool from_start, const Curve<Form::bernstein, Scalar, Dimension, Degree>& curve) {
  if (from_start) return curve;
  Curve<Form::bernstein, Scalar, Dimension, Degree> backwards(curve.degree());
  for (int i = 0; i <= curve.degree(); ++i)
    for (int axis = 0; axis < Dimension; ++axis) backwards(axis, i) = from_nearer_end(from_start, curve, axis, i);
  return backwards;
}

/// The curve with its control points in reverse order.
template <class Scalar, int Dimension, int Degree>
Curve<Form::bernstein, Scalar, Dimension, Degree> reversed(
    const Curve<Form::bernstein, Scalar, Dimension, Degree>& curve) {
  Curve<Form::bernstein, Scalar, Dimension, Degree> backwards(curve.degree());
  for (int i = 0; i <= curve.degree(); ++i)
    for (int axis = 0; axis < Dimension; ++axis) backwards(axis, i) = curve(axis, curve.degree() - i);
  return backwards;
}

/// Of two curves of the same degree the first, or the second.
template <Form F, class Scalar, int Dimension, int Degree>
const Curve<F, Scalar, Dimension, Degree>& chosen(bool is_first, const Curve<F, Scalar, Dimension, Degree>& first,
                                                  const Curve<F, Scalar, Dimension, Degree>& second) {
  return is_first ? first : second;
}

}  // namespace bezierbench
