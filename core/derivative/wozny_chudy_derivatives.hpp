// SPDX-License-Identifier: MIT
// Formula: for all orders up to r the points b_0^m, ..., b_r^m of level m = n - r of de Casteljau's triangle. Each is a
//   point of a curve of degree m, b_j^m = sum_i B_i,m(t) b_(j+i), and all have the same weights in Wozny and Chudy's
//   geometric algorithm: Q_j <- c_k Q_j + h_k b_(j+k) for k = 1, ..., m. The levels above are those of the triangle,
//   C^(k)(t) = (n)_k D^k b_0^(n-k). One order by itself is r = k.
// Source: [Chudy and Wozny 2023] evaluate derivatives in O(rnd); the use of one set of weights for the points of a
//   level is derived here.
// Cost: O(d r n) for all orders up to r, while r^2 is of the size of n. Memory O(d r).
// Bound: gamma_((3m+2)(m+1)+2k) A, m = n-k, where the points of level m have (3m+2)(m+1) roundings
//   (wozny_chudy_weights.hpp) and the rest is that of triangle_derivatives. In a call for more orders the points come
//   from a lower level and from three roundings for each level between, which are fewer. A weight may lose
//   4 (m+1)^2 2^m eta by underflow, as a point of wozny_chudy_positive does, and A has the points with their binomials.
// Fails: outside [0,1], where the weights may be negative, it is triangle_derivatives. The points of a level have the
//   size of the coordinates, as in triangle_derivatives. Near a multiple root, where the triangle loses next to
//   nothing, the rounded weights leave a mean error of up to 0.2 u p~ (study derivative-multiple-root).
#pragma once

#include <algorithm>

#include "core/derivative/triangle_derivatives.hpp"
#include "core/evaluate/schemes/wozny_chudy_weights.hpp"
#include "core/factorial.hpp"
#include "core/powers.hpp"

namespace bezierbench {

struct WoznyChudyDerivatives : LevelDerivatives<WoznyChudyDerivatives> {
  static constexpr DerivativeBound bound{
      .text = "gamma_((3m+2)(m+1)+2k) A, m = n-k",
      .differences =
          [](int n, int k, double u) {
            const double m = std::max(n - k, 0);
            return gamma_over_u((3 * m + 2) * (m + 1) + 2 * std::min(n, k), u);
          },
      .evaluation = [](int, int, double) { return 0.0; },
      .underflow =
          [](int n, int k) {
            const int m = std::max(n - k, 0);
            const double weight_terms = 4 * (m + 1.0) * (m + 1.0) * integer_power(2.0, m);
            return weight_terms + falling_factorial(n, k) * integer_power(2.0, std::min(n, k)) * 2 * m + 1;
          },
      .underflow_scales_with_coefficients = true};
  static constexpr MethodInfo info{.id = "wozny_chudy_derivatives",
                                   .label = "Wozny-Chudy, all orders",
                                   .problem = Problem::derivative,
                                   .form = Form::bernstein,
                                   .promise = bound.text,
                                   .one_minus_t = OneMinusT::normalised,
                                   .flops = "(n-k)(6+3d(k+1)) + d k(k+1)/2 + d + 4, 2(n-k) + 1 of them divisions",
                                   .citation = "[Chudy and Wozny 2023]; [Wozny and Chudy 2020]; bound derived here"};
  static constexpr std::string_view flops_of_all =
      "(n-k)(6+3d(k+1)) + 3d k(k+1)/2 + d k(k+1)(k+2)/6 + d(k+1) + 4, 2(n-k) + 1 of them divisions";

  /// The n - m + 1 points of level m, all by the same weights.
  template <class Scalar, int Dimension>
  static Curve<Form::bernstein, Scalar, Dimension> level(const Curve<Form::bernstein, Scalar, Dimension>& curve, int m,
                                                         const Scalar& t) {
    if (!(Scalar(0) <= t && t <= Scalar(1))) return TriangleDerivatives::level(curve, m, t);
    const int last = curve.degree() - m;
    Curve<Form::bernstein, Scalar, Dimension> q(last);
    for (int j = 0; j <= last; ++j)
      for (int axis = 0; axis < Dimension; ++axis) q(axis, j) = curve(axis, j);
    WoznyChudyWeights<Scalar> weights(m, t);
    for (int k = 1; k <= m; ++k) {
      const auto weight = weights.next(k);
      for (int j = 0; j <= last; ++j)
        for (int axis = 0; axis < Dimension; ++axis)
          q(axis, j) = weight.point * q(axis, j) + weight.control * curve(axis, j + k);
    }
    return q;
  }
};

}  // namespace bezierbench
