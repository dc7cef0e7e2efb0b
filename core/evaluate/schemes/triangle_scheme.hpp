// SPDX-License-Identifier: MIT
// The triangle of de Casteljau: b_i^k = step(b_i^(k-1), b_(i+1)^(k-1)), p(t) = b_0^n. Its variants differ in the step
// only, so they share this loop.
//
// All variants keep axes_independent, scaling_by_two and total, because their steps are sums, differences and products
// with t or the rounded 1-t; docs/proofs/de_casteljau.md has the proof.
#pragma once

#include "core/evaluate/evaluator.hpp"

namespace bezierbench {

/// Runs the triangle in place on `b`, a copy of the control points; `step(a, b)` combines two neighbours on one axis.
template <class Scalar, int Dimension, int Degree, class Step>
Point<Scalar, Dimension> run_triangle(Curve<Form::bernstein, Scalar, Dimension, Degree> b, Step step) {
  const int n = b.degree();
  for (int k = 1; k <= n; ++k)
    for (int i = 0; i <= n - k; ++i)
      for (int axis = 0; axis < Dimension; ++axis) b(axis, i) = step(b(axis, i), b(axis, i + 1));
  Point<Scalar, Dimension> point;
  for (int axis = 0; axis < Dimension; ++axis) point[axis] = b(axis, 0);
  return point;
}

}  // namespace bezierbench
