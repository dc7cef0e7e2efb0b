// SPDX-License-Identifier: MIT
// Formula: w_i^k = (1-t) w_i^(k-1) + t w_(i+1)^(k-1); p(t) = b_0^n with
//   b_i^k = ((1-t) w_i^(k-1) / w_i^k) b_i^(k-1) + (t w_(i+1)^(k-1) / w_i^k) b_(i+1)^(k-1).
//   Every intermediate point is a convex combination of control points.
// Bound: gamma_8n p~ for weights > 0 and 0 <= t <= 1. Along a path through the triangle each computed w_i^k divides at
//   one level and multiplies at the next, so that their errors cancel except those of the last weight, 3n. The other
//   roundings of a level are 1-t, its product with a weight, the quotient, the product with a point and the sum: 5n.
//   Underflow costs a level eta / min w in the product, eta in the quotient and 2 eta in the points, and eta / min w in
//   the last weight; each times max|b|.
// Fails: a weight of 0 can make 0/0. Outside [0,1] or with weights of both signs an intermediate weight may vanish.
#pragma once

#include <array>

#include "core/evaluate/evaluator.hpp"
#include "core/evaluate/schemes/triangle.hpp"

namespace bezierbench {

/// One step of the triangle: the convex combination of two points, each with its weight behind its coordinates.
template <class Scalar, std::size_t Size>
[[gnu::always_inline]] inline std::array<Scalar, Size> weighted_step(const std::array<Scalar, Size>& a,
                                                                     const std::array<Scalar, Size>& b, const Scalar& s,
                                                                     const Scalar& t) {
  const Scalar left = s * a[Size - 1];
  const Scalar right = t * b[Size - 1];
  std::array<Scalar, Size> next;
  next[Size - 1] = left + right;
  const Scalar left_share = left / next[Size - 1];
  const Scalar right_share = right / next[Size - 1];
  for (std::size_t axis = 0; axis + 1 < Size; ++axis) next[axis] = left_share * a[axis] + right_share * b[axis];
  return next;
}

/// Runs the triangle in place on a copy of the control points and weights.
template <class Scalar, int Dimension, int Degree>
Point<Scalar, Dimension> run_weighted_triangle(const Curve<Form::rational, Scalar, Dimension, Degree>& curve,
                                               const Scalar& t) {
  const Scalar s = Scalar(1) - t;
  constexpr auto size = static_cast<std::size_t>(Dimension) + 1;
  const auto in = [&curve](int i) {
    std::array<Scalar, size> values;
    for (int axis = 0; axis < Dimension; ++axis) values[static_cast<std::size_t>(axis)] = curve.points(axis, i);
    values[size - 1] = curve.weights[i];
    return values;
  };
  const auto step = [&](const auto& a, const auto& b) { return weighted_step<Scalar>(a, b, s, t); };
  const auto top = detail::apex_in_memory<size, Scalar>(curve.degree(), in, step);
  Point<Scalar, Dimension> point;
  for (int axis = 0; axis < Dimension; ++axis) point[axis] = top[static_cast<std::size_t>(axis)];
  return point;
}

struct DeCasteljauFarin : TakenAsGiven<Form::rational> {
  static constexpr MethodInfo info{.id = "de_casteljau_farin",
                                   .label = "de Casteljau, Farin's convex combinations",
                                   .form = Form::rational,
                                   .bound = ErrorBound{.text = "gamma_8n p~ for positive weights",
                                                       .amplification = Amplification::p_tilde_bernstein,
                                                       .factor = [](int n, double u) { return gamma_over_u(8 * n, u); },
                                                       .underflow = [](int n) { return 8.0 * n; },
                                                       .underflow_scales_with_coefficients = true,
                                                       .unit_interval_only = true,
                                                       .positive_weights_only = true},
                                   .one_minus_t = OneMinusT::normalised,
                                   .flops = "(5+3d) n(n+1)/2 + 1, n(n+1) of them divisions",
                                   .cost_exponent = 2,
                                   .citation = "[Farin 1983]"};
  static constexpr LaneRegisters lanes{.per_axis = 0, .shared = 8, .one_curve_only = true};

  static constexpr int largest_fixed_degree = 3;  ///< beyond, its divisions take longer than the loops around them

  template <class Scalar, int Dimension, int Degree>
  static Point<Scalar, Dimension> evaluate(const Curve<Form::rational, Scalar, Dimension, Degree>& curve, Scalar t) {
    return run_weighted_triangle(curve, t);
  }
};

}  // namespace bezierbench
