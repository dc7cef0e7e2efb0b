// SPDX-License-Identifier: MIT
// Derivatives from the points of one level of de Casteljau's triangle: (n)_k D^k b_0^(n-k) is the derivative of order
// k. The methods that share this differ in how they get the points of level n - r, where r is the highest order; the
// levels above follow by steps of the triangle.
#pragma once

#include "core/derivative/derivative.hpp"
#include "core/factorial.hpp"

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

/// All members of a method except `info` and `bound`: `Method::level(curve, m, t)` returns a curve whose first
/// n - m + 1 control points are those of level m of the triangle; the others are not used.
template <class Method>
struct LevelDerivatives {
  template <int Dimension>
  static CurveAndOrder<Form::bernstein, Dimension> prepare(const Curve<Form::bernstein, double, Dimension>& curve,
                                                           int order) {
    return {curve, order};
  }

  template <int Dimension>
  static Point<double, Dimension> evaluate(const CurveAndOrder<Form::bernstein, Dimension>& prepared, double t) {
    Point<double, Dimension> result;
    run(prepared.curve, prepared.order, prepared.order, t, [&](int, const auto& derivative) { result = derivative; });
    return result;
  }

  template <class Scalar, int Dimension, class Take>
  static void all(const Curve<Form::bernstein, Scalar, Dimension>& curve, int last_order, const Scalar& t, Take take) {
    run(curve, 0, last_order, t, take);
  }

 private:
  /// Calls take(k, C^(k)(t)) for every order k from `last_order` down to `first_order`.
  template <class Scalar, int Dimension, class Take>
  static void run(const Curve<Form::bernstein, Scalar, Dimension>& curve, int first_order, int last_order,
                  const Scalar& t, Take take) {
    const int n = curve.degree();
    int k = last_order;
    for (; k >= first_order && k > n; --k) take(k, Point<Scalar, Dimension>::Constant(Scalar(0)).eval());
    if (k < first_order) return;
    auto b = Method::level(curve, n - k, t);
    const Scalar s = Scalar(1) - t;
    for (; k > first_order; --k) {
      take(k, detail::top_difference(b, n, k));
      detail::raise(b, k, s, t);
    }
    take(k, detail::top_difference(b, n, k));
  }
};

}  // namespace bezierbench
