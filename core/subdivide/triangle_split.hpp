// SPDX-License-Identifier: MIT
// The triangle of de Casteljau with both its sides kept: b_i^k = step(b_i^(k-1), b_(i+1)^(k-1)), left_k = b_0^k and
// right_(n-k) = b_(n-k)^k. Its variants share this loop and differ only in the step.
#pragma once

#include "core/subdivide/subdivision.hpp"

namespace bezierbench {

/// Splits into both halves; `step(a, b)` combines two neighbours on one axis.
template <class Scalar, int Dimension, int Degree, class Step>
Halves<Curve<Form::bernstein, Scalar, Dimension, Degree>> split_by_triangle(
    const Curve<Form::bernstein, Scalar, Dimension, Degree>& curve, Step step) {
  const int n = curve.degree();
  Halves<Curve<Form::bernstein, Scalar, Dimension, Degree>> halves{curve, curve};
  auto& b = halves.right;  // level k leaves the last point of level k - 1 at its place in right
  for (int k = 1; k <= n; ++k) {
    for (int i = 0; i <= n - k; ++i)
      for (int axis = 0; axis < Dimension; ++axis) b(axis, i) = step(b(axis, i), b(axis, i + 1));
    for (int axis = 0; axis < Dimension; ++axis) halves.left(axis, k) = b(axis, 0);
  }
  return halves;
}

}  // namespace bezierbench
