// SPDX-License-Identifier: MIT
// Formula: q_2k + q_(2k+1) t at every level: neighbours are joined with t, pairs with t^2, fours with t^4, and so on.
// Source: [Estrin 1960]; [Muller 2016], section 4.3.2.
// Cost: 2dn + log2 n flops per point, in a chain of log2 n steps instead of n.
// Bound: gamma_(n+2L) sum |q_j| |t|^j with L = ceil(log2(n+1)) levels: a coefficient meets at most L products and L
//   sums, and its power of t, formed by squaring, has at most n roundings. A power that underflows loses up to |q_j|
//   eta.
// Fails: as any power form, when its coefficients came out of a rounded conversion.
#pragma once

#include "core/bound/amplification.hpp"
#include "core/evaluate/evaluator.hpp"

namespace bezierbench {

/// Joins neighbours with t until one value is left on each axis; works on a copy of the coefficients.
template <class Scalar, int Dimension, int Degree>
Point<Scalar, Dimension> join_neighbours(const Curve<Form::power, Scalar, Dimension, Degree>& curve, const Scalar& t) {
  auto q = working_copy(curve);
  int count = curve.degree() + 1;
  for (Scalar power = t; count > 1; power *= power) {
    const int pairs = count / 2;
    for (int k = 0; k < pairs; ++k)
      for (int axis = 0; axis < Dimension; ++axis) q(axis, k) = q(axis, 2 * k) + q(axis, 2 * k + 1) * power;
    if (count % 2 != 0)
      for (int axis = 0; axis < Dimension; ++axis) q(axis, pairs) = q(axis, count - 1);
    count = (count + 1) / 2;  // of count alone, so that compilers unroll this loop for a fixed degree
  }
  Point<Scalar, Dimension> point;
  for (int axis = 0; axis < Dimension; ++axis) point[axis] = q(axis, 0);
  return point;
}

struct Estrin : TakenAsGiven<Form::power> {
  static constexpr int levels(int n) {
    int count = 0;
    while ((1 << count) < n + 1) ++count;
    return count;
  }

  static constexpr MethodInfo info{
      .id = "estrin",
      .label = "Estrin",
      .form = Form::power,
      .bound = ErrorBound{.text = "gamma_(n+2L) p~, L = ceil(log2(n+1))",
                          .amplification = Amplification::p_tilde_power,
                          .factor = [](int n, double u) { return gamma_over_u(n + 2 * levels(n), u); },
                          .underflow = [](int n) { return 4.0 * (n + 1) * (n + 1); },
                          .underflow_scales_with_coefficients = true,
                          .growth = [](int n) { return n + 1.0; }},
      .flops = "2dn + log2 n",
      .citation = "[Estrin 1960]"};

  /// Written out for a degree, it has neither a copy of the coefficients in memory nor a count of those that are left.
  static constexpr int largest_fixed_degree = 20;

  template <class Scalar, int Dimension, int Degree>
  static Point<Scalar, Dimension> evaluate(const Curve<Form::power, Scalar, Dimension, Degree>& curve, Scalar t) {
    return join_neighbours(curve, t);
  }
};

}  // namespace bezierbench
