// SPDX-License-Identifier: MIT
// Derivatives from the points of one level of de Casteljau's triangle: (n)_k D^k b_0^(n-k) is the derivative of order
// k. The methods that share this differ in how they get the points of level n - r, where r is the highest order; the
// levels above follow by steps of the triangle.
#pragma once

#include <algorithm>

#include "core/basis/falling_factorial.hpp"
#include "core/derivative/derivative.hpp"

namespace bezierbench {

namespace detail {

/// b_i <- (1-t) b_i + t b_(i+1) for i < count.
template <class Scalar, int Dimension>
void raise(Curve<Form::bernstein, Scalar, Dimension>& b, int count, const Scalar& s, const Scalar& t) {
  for (int i = 0; i < count; ++i)
    for (int axis = 0; axis < Dimension; ++axis) b(axis, i) = s * b(axis, i) + t * b(axis, i + 1);
}

/// (n)_k D^k b_0 of the first k + 1 points of `level`, k = `order`.
template <class Scalar, int Dimension>
Point<Scalar, Dimension> top_difference(const Curve<Form::bernstein, Scalar, Dimension>& level, int n, int order) {
  Curve<Form::bernstein, Scalar, Dimension> difference(order);
  for (int i = 0; i <= order; ++i)
    for (int axis = 0; axis < Dimension; ++axis) difference(axis, i) = level(axis, i);
  for (int m = order; m > 0; --m)
    for (int i = 0; i < m; ++i)
      for (int axis = 0; axis < Dimension; ++axis) difference(axis, i) = difference(axis, i + 1) - difference(axis, i);
  const auto factor = static_cast<Scalar>(falling_factorial(n, order));
  Point<Scalar, Dimension> result;
  for (int axis = 0; axis < Dimension; ++axis) result[axis] = factor * difference(axis, 0);
  return result;
}

}  // namespace detail

/// The points of a level of the triangle, from the start; those beyond its n - level + 1 mean nothing.
template <class Scalar, int Dimension>
Curve<Form::bernstein, Scalar, Dimension> triangle_level(const Curve<Form::bernstein, Scalar, Dimension>& curve,
                                                         int level, const Scalar& t) {
  auto b = curve;
  const Scalar s = Scalar(1) - t;
  for (int m = 0; m < level; ++m) detail::raise(b, curve.degree() - m, s, t);
  return b;
}

/// Calls take(k, C^(k)(t)) for every order k from `last_order` down to `first_order`. `level_of(curve, m, t)` gives the
/// points of level m.
template <class Scalar, int Dimension, class LevelOf, class Take>
void level_derivatives(const Curve<Form::bernstein, Scalar, Dimension>& curve, int first_order, int last_order,
                       const Scalar& t, LevelOf level_of, Take take) {
  const int n = curve.degree();
  int k = last_order;
  for (; k >= first_order && k > n; --k) take(k, Point<Scalar, Dimension>::Constant(Scalar(0)).eval());
  if (k < first_order) return;
  auto b = level_of(curve, n - k, t);
  const Scalar s = Scalar(1) - t;
  for (; k > first_order; --k) {
    take(k, detail::top_difference(b, n, k));
    detail::raise(b, k, s, t);
  }
  take(k, detail::top_difference(b, n, k));
}

}  // namespace bezierbench
