// SPDX-License-Identifier: MIT
// The triangle of de Casteljau: b_i^k = step(b_i^(k-1), b_(i+1)^(k-1)), p(t) = b_0^n. Its variants differ in the step
// only, so they share this loop.
//
// What all variants keep, because their steps are sums, differences and products with t or the rounded 1-t:
//   axes_independent: a coordinate is computed from its own axis and t.
//   scaling_by_two: let b_i be multiples of beta and t one of tau, powers of two up to 1 with beta tau^n >= eta. The
//     rounded 1-t is a multiple of tau, since rounding keeps multiples of a power of two >= eta. Products, sums and
//     results of level k are multiples of beta tau^k >= eta then, so that results below the normal numbers are exact,
//     and doubling the points doubles the result of every operation. A level makes no number larger than 4 max|b|.
//   total: a step makes |result| <= (1 + 2 |t|) (1 + u)^4 max(|a|, |b|) < 4 (1 + |t|) max(|a|, |b|), which is in range.
// An infinity or NaN reaches the result: each step is infinite or NaN where one of its operands or operations is. So in
// proofs about finite results no operation overflows.
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
