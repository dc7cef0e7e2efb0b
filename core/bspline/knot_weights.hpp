// SPDX-License-Identifier: MIT
// The step that methods for B-spline curves share: a blossom as a function of one argument, between its values at two
// knots.
//
// Both weights are quotients of differences, so that neither is small by cancellation: the difference of two doubles,
// the width and the quotient round once each, which is a relative error of gamma_3. Between the knots both are in [0,
// 1], for rounding is monotone, and a quotient loses at most eta/2 by underflow. The textbook's 1 - alpha has an error
// relative to 1 instead.
#pragma once

#include <cmath>
#include <concepts>

#include "core/curve.hpp"

namespace bezierbench {

template <class Scalar>
struct KnotWeights {
  Scalar left;   ///< of the value at the left knot
  Scalar right;  ///< of the value at the right knot
};

/// For left < right. Where the width overflows all three are halved: what that rounds is below 2^-1074 of it.
template <class Scalar>
KnotWeights<Scalar> knot_weights(const Scalar& left, const Scalar& right, const Scalar& x) {
  const Scalar width = right - left;
  if constexpr (std::floating_point<Scalar>)
    if (std::isinf(width)) return knot_weights<Scalar>(left / 2, right / 2, x / 2);
  return {Scalar(right - x) / width, Scalar(x - left) / width};
}

/// The value at x from those at the knots, columns i and i + 1 of `points`; written to column `to`.
template <class C, class Scalar>
void step_between(const KnotWeights<Scalar>& weights, int i, int to, C& points) {
  for (int axis = 0; axis < C::dimension; ++axis)
    points(axis, to) = weights.left * points(axis, i) + weights.right * points(axis, i + 1);
}

}  // namespace bezierbench
