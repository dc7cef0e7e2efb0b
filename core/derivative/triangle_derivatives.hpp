// SPDX-License-Identifier: MIT
// Formula: C^(k)(t) = (n)_k D^k b_0^(n-k): differences of the points b_i^(n-k) of level n - k of de Casteljau's
//   triangle. One triangle gives the point and all derivatives.
// Bound: gamma_(3(n-k)+2k) A: the points of level n - k carry gamma_(3(n-k)) sum |b_(i+j)| B_j,n-k(t); k differences
//   and k roundings of the product with (n)_k follow. A product of the triangle may underflow by eta/2, twice a level;
//   k differences double that k times, and (n)_k magnifies it.
// Fails: far from the origin, where the triangle's roundings have the size of u times the coordinates. The differences
//   keep this error even where differences of the control points themselves are exact.
#pragma once

#include <algorithm>

#include "core/derivative/derivative.hpp"
#include "core/factorial.hpp"
#include "core/powers.hpp"

namespace bezierbench {

// Derivatives from the points of one level of de Casteljau's triangle: (n)_k D^k b_0^(n-k) is the derivative of order
// k. The methods that share this differ in how they get the points of level n - r, where r is the highest order; the
// levels above follow by steps of the triangle.

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

struct TriangleDerivatives : LevelDerivatives<TriangleDerivatives> {
  static constexpr DerivativeBound bound{
      .text = "gamma_(3(n-k)+2k) A",
      .differences = [](int n, int k,
                        double u) { return gamma_over_u(3 * std::max(n - k, 0) + 2 * std::min(n, k), u); },
      .evaluation = [](int, int, double) { return 0.0; },
      .underflow =
          [](int n, int k) {
            return falling_factorial(n, k) * integer_power(2.0, std::min(n, k)) * 2 * std::max(n - k, 0) + 1;
          }};
  static constexpr MethodInfo info{.id = "triangle_derivatives",
                                   .label = "de Casteljau triangle, all orders",
                                   .problem = Problem::derivative,
                                   .form = Form::bernstein,
                                   .promise = bound.text,
                                   .one_minus_t = OneMinusT::summed,
                                   .flops = "3d (n(n+1)-k(k+1))/2 + d k(k+1)/2 + 2k + 1",
                                   .cost_exponent = 2,
                                   .citation = "[Farin 2002], derivatives from the triangle"};
  static constexpr std::string_view flops_of_all = "3d n(n+1)/2 + d k(k+1)(k+2)/6 + d(k+1) + 2";

  template <class Scalar, int Dimension>
  static Curve<Form::bernstein, Scalar, Dimension> level(const Curve<Form::bernstein, Scalar, Dimension>& curve, int m,
                                                         const Scalar& t) {
    auto b = curve;
    const Scalar s = Scalar(1) - t;
    for (int k = 0; k < m; ++k) detail::raise(b, curve.degree() - k, s, t);
    return b;
  }
};

}  // namespace bezierbench
