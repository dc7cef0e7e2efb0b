// SPDX-License-Identifier: MIT
// Formula: the differences D^k b_i as pairs high + low; de Casteljau's triangle in two parts on these pairs
//   (core/evaluate/schemes/compensated_triangle.hpp); C^(k)(t) = (n)_k times their sum, rounded once.
// Cost: once 14 d k (2n-k+1)/2 flops.
// Bound: u |C^(k)| + 4k u^2 A + (9m(m+3)/2 + 6m + 3) u^2 p~ to first order, m = n-k, and k more roundings of |C^(k)|
//   where (n)_k is not below 2^53; here |C^(k)| <= p~. A difference of pairs has the exact error of its high parts and
//   rounds twice, sums of at most 2u and 3u times the magnitudes that it is taken of: 3 u^2 a level, 4 with what is of
//   higher order. The triangle begins with V_0 = p~ and V_1 = u p~; its steps are those of compensated_triangle.hpp. In
//   the last step the product with the second part and its sum round, at most u (2 V_1 + u V_0). Differences cannot
//   underflow. Each of 5m products of the triangle may lose eta, and so may each of two products with (n)_k.
// Fails: past A / |C^(k)| of 1/u it loses digits again. Its cost is quadratic.
#pragma once

#include <algorithm>

#include "core/derivative/derivative.hpp"
#include "core/evaluate/schemes/compensated_triangle.hpp"
#include "core/factorial.hpp"

namespace bezierbench {

namespace detail {

/// In u p~, what the triangle drops and the last step rounds: of second order in u.
constexpr double second_order_roundings(int n, int k, double u) {
  const PartSizes<2> first{{1, 1}, 0};  // V_0 = p~, V_1 = u p~
  const auto sizes = after_steps<2, TriangleRoundings>(n - k, u, first);
  return (sizes.dropped + 2 * sizes.parts[1] + sizes.parts[0]) * u * (1 + gamma_over_u(k + 8.0, u) * u);
}

}  // namespace detail

struct CompensatedDifferences {
  static constexpr DerivativeBound bound{
      .text = "u p~ + 4k u^2 A + (9m(m+3)/2 + 6m + 3) u^2 p~, m = n-k",
      .differences = [](int n, int k,
                        double u) { return 4 * std::min(n, k) * u * (1 + detail::second_order_roundings(n, k, u)); },
      .evaluation =
          [](int n, int k, double u) {
            const double result = falling_factorial(n, k) < 0x1p+53 ? 1 : gamma_over_u(k + 1, u);
            return result + detail::second_order_roundings(n, k, u);
          },
      .underflow = [](int n, int k) { return 5 * falling_factorial(n, k) * std::max(n - k, 0) + 2; }};
  static constexpr MethodInfo info{.id = "compensated_differences",
                                   .label = "Differences, compensated",
                                   .problem = Problem::derivative,
                                   .form = Form::bernstein,
                                   .promise = bound.text,
                                   .flops = "18d (n-k)(n-k+1)/2 + 5d + 6",
                                   .cost_exponent = 2,
                                   .prepare_exponent = 2,
                                   .citation = "[Jiang et al. 2010], on differences in pairs; bound derived here"};

  template <int Dimension>
  struct Prepared {
    Curve<Form::bernstein, double, Dimension> high;
    Curve<Form::bernstein, double, Dimension> low;
    double factor;  ///< (n)_k
  };

  template <int Dimension>
  static Prepared<Dimension> prepare(const Curve<Form::bernstein, double, Dimension>& curve, int order) {
    const int n = curve.degree();
    const int last = std::max(n - order, 0);
    Prepared<Dimension> prepared{Curve<Form::bernstein, double, Dimension>(last),
                                 Curve<Form::bernstein, double, Dimension>(last), falling_factorial(n, order)};
    auto high = curve;
    Curve<Form::bernstein, double, Dimension> low(n);
    for (int axis = 0; axis < Dimension; ++axis) {
      for (int i = 0; i <= n; ++i) low(axis, i) = 0;
      for (int k = 1; k <= std::min(order, n); ++k)
        for (int i = 0; i <= n - k; ++i) {
          const auto difference = two_sum(high(axis, i + 1), -high(axis, i));
          const auto pair = two_sum(difference.value, (low(axis, i + 1) - low(axis, i)) + difference.error);
          high(axis, i) = pair.value;
          low(axis, i) = pair.error;
        }
      for (int i = 0; i <= last; ++i) {
        prepared.high(axis, i) = order > n ? 0 : high(axis, i);
        prepared.low(axis, i) = order > n ? 0 : low(axis, i);
      }
    }
    return prepared;
  }

  template <int Dimension>
  static Point<double, Dimension> evaluate(const Prepared<Dimension>& prepared, double t) {
    const int n = prepared.high.degree();
    const auto s = two_sum(1.0, -t);
    auto high = prepared.high;
    auto low = prepared.low;
    Point<double, Dimension> result;
    for (int axis = 0; axis < Dimension; ++axis) {
      for (int k = 1; k <= n; ++k)
        for (int i = 0; i <= n - k; ++i) {
          const auto next =
              compensated_step<2, double>({high(axis, i), low(axis, i)}, {high(axis, i + 1), low(axis, i + 1)}, s, t);
          high(axis, i) = next[0];
          low(axis, i) = next[1];
        }
      const auto product = two_prod(prepared.factor, high(axis, 0));
      result[axis] = product.value + (product.error + prepared.factor * low(axis, 0));
    }
    return result;
  }
};

}  // namespace bezierbench
