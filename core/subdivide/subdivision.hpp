// SPDX-License-Identifier: MIT
// The concept of a method for subdivision: `info`, and one function from a curve and t to the control points of the
// curve over [0, t] and over [t, 1].
#pragma once

#include <concepts>

#include "core/curve.hpp"
#include "core/method.hpp"
#include "core/subdivide/split_bound.hpp"

namespace bezierbench {

/// Both parts of a curve, in its form, degree and direction, each over parameters from 0 to 1.
template <class C>
struct Halves {
  C left;   ///< over [0, t]; its last control point is the junction
  C right;  ///< over [t, 1]; its first control point is the junction
};

/// Properties of the values of the halves, among which -0 equals 0. A promised property holds for every curve and every
/// t in [0, 1] while nothing overflows. For a property that a method does not promise, the tests have a curve without
/// it.
struct SplitPromises {
  bool keeps_ends;            ///< the first control point of left is b_0 and the last of right b_n
  bool shares_junction;       ///< the last control point of left is the first of right
  bool exact_at_zero;         ///< at t = 0 right is the curve, and each control point of left b_0
  bool exact_at_one;          ///< at t = 1 left is the curve, and each control point of right b_n
  bool reproduces_constants;  ///< where all b_i are equal, so are all control points of the halves
  bool mirrors;               ///< the reversed curve, split at 1 - t where that is exact, has the reversed halves
};

/// `split(curve, t)` returns the halves, for finite t. It is pure, and neither allocates, prints nor throws. A method
/// with proved bounds has a `SplitBound bound`.
template <class M>
concept SplitMethod = requires(const Curve<M::info.form, double, 2>& curve, double t) {
  requires M::info.problem == Problem::subdivision;
  { M::promises } -> std::convertible_to<SplitPromises>;
  { M::split(curve, t) } -> std::same_as<Halves<Curve<M::info.form, double, 2>>>;
};

// The triangle of de Casteljau with both its sides kept: b_i^k = step(b_i^(k-1), b_(i+1)^(k-1)), left_k = b_0^k and
// right_(n-k) = b_(n-k)^k. Its variants share this loop and differ only in the step.

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
