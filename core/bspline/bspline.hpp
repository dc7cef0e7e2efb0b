// SPDX-License-Identifier: MIT
// The concepts of a method for B-spline curves. A curve of degree m >= 1 depends in one knot span on 2m knots
// u_0 <= ... <= u_(2m-1), the span being [a, c] with a = u_(m-1) < c = u_m, and on m + 1 control points d_i:
//   p(t) = sum d_i N_i(t),    where d_i is the blossom of p at u_i, ..., u_(i+m-1).
// No other knot and no other control point has any influence on the span.
#pragma once

#include <concepts>
#include <span>

#include "core/bound/bspline_bound.hpp"
#include "core/curve.hpp"
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

}  // namespace bezierbench
