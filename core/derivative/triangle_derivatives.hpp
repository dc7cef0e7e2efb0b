// SPDX-License-Identifier: MIT
// Formula: C^(k)(t) = (n)_k D^k b_0^(n-k): differences of the points b_i^(n-k) of level n - k of de Casteljau's
//   triangle. One triangle gives the point and all derivatives.
// Source: [Farin 2002], derivatives and the de Casteljau algorithm.
// Cost: 3 d (n(n+1) - k(k+1))/2 + d k(k+1)/2 + 2k + 1 flops per point; for all orders up to r, 3 d n(n+1)/2 for the
//   triangle, d k(k+1)/2 for each k, d(r+1) + 2.
// Bound: gamma_(3(n-k)+2k) A: the points of level n - k carry gamma_(3(n-k)) sum |b_(i+j)| B_j,n-k(t); k differences
//   and k roundings of the product with (n)_k follow. A product of the triangle may underflow by eta/2, twice a level;
//   k differences double that k times, and (n)_k magnifies it.
// Fails: far from the origin, where the triangle's roundings have the size of u times the coordinates. The differences
//   keep this error even where differences of the control points themselves are exact.
#pragma once

#include <algorithm>

#include "core/derivative/level_derivatives.hpp"
#include "core/factorial.hpp"
#include "core/powers.hpp"

namespace bezierbench {

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
