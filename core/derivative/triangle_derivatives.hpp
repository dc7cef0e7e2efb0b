// SPDX-License-Identifier: MIT
// Formula: C^(k)(t) = (n)_k D^k b_0^(n-k): differences of the points b_i^(n-k) of level n - k of de Casteljau's
//   triangle. One triangle gives the point and all derivatives.
// Source: [Farin 2002], derivatives and the de Casteljau algorithm.
// Cost: 3 d (n(n+1) - k(k+1))/2 + d k(k+1)/2 + 2k + 1 flops per point; for all orders up to r, 3 d n(n+1)/2 for the
//   triangle and d k(k+1)/2 for each k.
// Bound: gamma_(3(n-k)+2k) A: the points of level n - k carry gamma_(3(n-k)) sum |b_(i+j)| B_j,n-k(t); k differences
//   and k roundings of the product with (n)_k follow. A product of the triangle may underflow by eta/2, twice a level;
//   k differences double that k times, and (n)_k magnifies it.
// Fails: far from the origin, where the triangle's roundings have the size of u times the coordinates. The differences
//   keep this error even where differences of the control points themselves are exact.
#pragma once

#include <algorithm>

#include "core/basis/falling_factorial.hpp"
#include "core/basis/integer_power.hpp"
#include "core/derivative/derivative.hpp"

namespace bezierbench {

struct TriangleDerivatives {
  static constexpr DerivativeBound bound{
      .text = "gamma_(3(n-k)+2k) A",
      .differences = [](int n, int k,
                        double u) { return gamma_over_u(3 * std::max(n - k, 0) + 2 * std::min(n, k), u); },
      .evaluation = [](int, int, double) { return 0.0; },
      .underflow =
          [](int n, int k) {
            return falling_factorial(n, k) * integer_power(2.0, std::min(n, k)) * 2 * std::max(n - k, 0) + 1;
          },
      .underflow_scales_with_coefficients = false};
  static constexpr MethodInfo info{.id = "triangle_derivatives",
                                   .label = "de Casteljau triangle, all orders",
                                   .problem = Problem::derivative,
                                   .form = Form::bernstein,
                                   .promise = bound.text,
                                   .one_minus_t = OneMinusT::summed,
                                   .flops = "3d (n(n+1)-k(k+1))/2 + d k(k+1)/2 + 2k + 1",
                                   .cost_exponent = 2,
                                   .citation = "[Farin 2002], derivatives from the triangle"};

  template <int Dimension>
  struct Prepared {
    Curve<Form::bernstein, double, Dimension> curve;
    int order;
  };

  template <int Dimension>
  static Prepared<Dimension> prepare(const Curve<Form::bernstein, double, Dimension>& curve, int order) {
    return {curve, order};
  }

  template <int Dimension>
  static Point<double, Dimension> evaluate(const Prepared<Dimension>& prepared, double t) {
    Point<double, Dimension> result;
    run(prepared.curve, prepared.order, prepared.order, t, [&](int, const auto& derivative) { result = derivative; });
    return result;
  }

  /// The derivatives of orders 0 to `last_order` at t; derivative k is column k.
  template <int Dimension>
  static Eigen::Matrix<double, Dimension, Eigen::Dynamic> all(const Curve<Form::bernstein, double, Dimension>& curve,
                                                              int last_order, double t) {
    Eigen::Matrix<double, Dimension, Eigen::Dynamic> columns(Dimension, last_order + 1);
    run(curve, 0, last_order, t, [&](int order, const auto& derivative) { columns.col(order) = derivative; });
    return columns;
  }

 private:
  /// Calls take(k, C^(k)(t)) for every order k from `last_order` down to `first_order`.
  template <int Dimension, class Take>
  static void run(const Curve<Form::bernstein, double, Dimension>& curve, int first_order, int last_order, double t,
                  Take take) {
    const int n = curve.degree();
    for (int k = last_order; k > std::max(n, first_order - 1); --k) take(k, Point<double, Dimension>::Zero().eval());
    auto b = curve;
    const double s = 1 - t;
    for (int level = 0; level <= n - first_order; ++level) {
      if (n - level <= last_order) take(n - level, top_difference(b, n, n - level));
      for (int i = 0; i < n - level; ++i)
        for (int axis = 0; axis < Dimension; ++axis) b(axis, i) = s * b(axis, i) + t * b(axis, i + 1);
    }
  }

  /// (n)_k D^k b_0 for the first k + 1 points of `level`, k = `order`.
  template <int Dimension>
  static Point<double, Dimension> top_difference(Curve<Form::bernstein, double, Dimension> level, int n, int order) {
    for (int m = order; m > 0; --m)
      for (int i = 0; i < m; ++i)
        for (int axis = 0; axis < Dimension; ++axis) level(axis, i) = level(axis, i + 1) - level(axis, i);
    Point<double, Dimension> result;
    for (int axis = 0; axis < Dimension; ++axis) result[axis] = falling_factorial(n, order) * level(axis, 0);
    return result;
  }
};

}  // namespace bezierbench
