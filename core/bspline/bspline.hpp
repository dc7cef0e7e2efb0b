// SPDX-License-Identifier: MIT
// The concepts of a method for B-spline curves. A curve of degree m >= 1 depends in one knot span on 2m knots
// u_0 <= ... <= u_(2m-1), the span being [a, c] with a = u_(m-1) < c = u_m, and on m + 1 control points d_i:
//   p(t) = sum d_i N_i(t),    where d_i is the blossom of p at u_i, ..., u_(i+m-1).
// No other knot and no other control point has any influence on the span.
#pragma once

#include <cmath>
#include <concepts>
#include <span>

#include "core/bound/bspline_bound.hpp"
#include "core/curve.hpp"
#include "core/evaluate/schemes/triangle.hpp"
#include "core/method.hpp"

namespace bezierbench {

/// One knot span of a B-spline curve. Refers to the knots.
template <class ScalarT, int DimensionT>
struct BsplineSpan {
  using Scalar = ScalarT;

  /// Room for the control points of a curve over `span_knots`, 2m knots.
  explicit BsplineSpan(std::span<const Scalar> span_knots)
      : control_points(static_cast<int>(span_knots.size()) / 2), knots(span_knots) {}

  /// The m + 1 control points of the B-spline curve, which are not in Bernstein form.
  Curve<Form::bernstein, Scalar, DimensionT> control_points;
  std::span<const Scalar> knots;  ///< 2m

  [[nodiscard]] int degree() const { return control_points.degree(); }
  [[nodiscard]] const Scalar& knot(int i) const { return knots[static_cast<std::size_t>(i)]; }
  [[nodiscard]] const Scalar& begin() const { return knot(degree() - 1); }
  [[nodiscard]] const Scalar& end() const { return knot(degree()); }
};

/// Whether these are the knots of a span that is not empty, in ascending order.
template <class Scalar>
bool are_span_knots(std::span<const Scalar> knots) {
  if (knots.empty() || knots.size() % 2 != 0) return false;
  for (std::size_t k = 1; k < knots.size(); ++k)
    if (!(knots[k - 1] <= knots[k])) return false;
  return knots[knots.size() / 2 - 1] < knots[knots.size() / 2];
}

/// `evaluate(span, t)` is the point at t in [a, c]. It is pure, and neither allocates, prints nor throws. A method with
/// proved bounds has a `BsplineBound bound`.
template <class M>
concept BsplineEvaluator = requires(const BsplineSpan<double, 2>& span, double t) {
  requires M::info.problem == Problem::bspline;
  { M::evaluate(span, t) } -> std::same_as<Point<double, 2>>;
};

/// `convert(span)` is the Bernstein form of the span, over parameters from 0 at a to 1 at c. Likewise pure. Points
/// follow from it by `point_of_span`.
template <class M>
concept BsplineConversion = requires(const BsplineSpan<double, 2>& span) {
  requires M::info.problem == Problem::bspline;
  { M::convert(span) } -> std::same_as<Curve<Form::bernstein, double, 2>>;
};

// The step that methods for B-spline curves share: a blossom as a function of one argument, between its values at two
// knots.
//
// Both weights are quotients of differences, so that neither is small by cancellation: the difference of two doubles,
// the width and the quotient round once each, which is a relative error of gamma_3. Between the knots both are in [0,
// 1], for rounding is monotone, and a quotient loses at most eta/2 by underflow. The textbook's 1 - alpha has an error
// relative to 1 instead.

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

// The basis functions of a B-spline curve that are not zero in a knot span, at one t of it, by the recurrence of de
// Boor and Cox: N_i of degree r is the sum of those of degree r - 1 to its left and right, weighted with the distances
// of t from the ends of their supports.
//
// Every path has five roundings a level, three of a weight, a product and a sum; all weights are >= 0 between a and c.

/// N_0(t), ..., N_n(t), in the order of the control points.
template <class Scalar, int Dimension>
PerCoefficient<Scalar, dynamic> basis_functions(const BsplineSpan<Scalar, Dimension>& span, const Scalar& t) {
  const int n = span.degree();
  auto basis = per_coefficient<Scalar, dynamic>(n);
  basis[0] = Scalar(1);
  for (int r = 1; r <= n; ++r) {
    Scalar carried(0);
    for (int i = 0; i < r; ++i) {
      const auto weights = knot_weights(span.knot(n - r + i), span.knot(n + i), t);
      const Scalar lower = basis[i];
      basis[i] = carried + weights.left * lower;
      carried = weights.right * lower;
    }
    basis[r] = carried;
  }
  return basis;
}

// A point of a knot span from its Bernstein form: the triangle of de Casteljau with the weights (c - t) / (c - a) and
// (t - a) / (c - a), each a quotient of its own (`knot_weights`). So there is no rounded parameter of which 1 - t
// would be formed, and each level has five roundings: three of a weight, a product and a sum.

/// The roundings of every path through the triangle.
constexpr int roundings_of_point_of_span(int degree) { return 5 * degree; }

template <class Scalar, int Dimension>
Point<Scalar, Dimension> point_of_span(const Curve<Form::bernstein, Scalar, Dimension>& bernstein, const Scalar& a,
                                       const Scalar& c, const Scalar& t) {
  const auto weights = knot_weights(a, c, t);
  return run_triangle(bernstein, [&weights](const Scalar& left, const Scalar& right) {
    return Scalar(weights.left * left + weights.right * right);
  });
}

}  // namespace bezierbench
