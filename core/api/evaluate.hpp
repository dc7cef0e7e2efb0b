// SPDX-License-Identifier: MIT
// Points of Bezier curves, in one call:
//
//   std::vector<std::array<double, 2>> points{{0, 0}, {1, 2}, {3, 1}};
//   std::array<double, 2> p = bezierbench::evaluate(points, 0.25);
//   std::array<double, 2> q = bezierbench::evaluate<bezierbench::VolkSchumaker>(points, 0.25);
//
// The methods are in core/evaluate, one header each with formula, source, cost, bound and known failure; all of them
// come with this file, and so do the conversions in core/convert, which `Via<Differences, Horner>` puts in front of a
// method. Methods named CorrectlyRounded*, and conversions named Exact*, need the compiled part of the package.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <type_traits>
#include <utility>

#include "core/api/control_points.hpp"
#include "core/api/recommended.hpp"
#include "core/bound/amplification.hpp"
#include "core/bound/locality.hpp"
#include "core/convert/roster.hpp"
#include "core/evaluate/roster.hpp"
#include "core/evaluate/via.hpp"

namespace bezierbench {

namespace detail {

/// The degree that the type of the points says, or `dynamic`.
template <ControlPoints Points>
inline constexpr int fixed_degree = fixed_count<Points> == std::dynamic_extent
                                        ? dynamic
                                        : static_cast<int>(fixed_count<Points>) - 1;

template <class Points>
inline constexpr int dimension_of_points = static_cast<int>(array_size<PointOf<Points>>);

template <Form F, class Points>
using CurveOf = Curve<F, ScalarOf<Points>, dimension_of_points<Points>, fixed_degree<Points>>;

template <class Points, class C>
void copy_points(const Points& points, C& curve) {
  const auto* point = std::ranges::data(points);
  for (int i = 0; i <= curve.degree(); ++i, ++point)
    for (int axis = 0; axis < dimension_of_points<Points>; ++axis)
      curve(axis, i) = (*point)[static_cast<std::size_t>(axis)];
}

template <Form F, class Points>
CurveOf<F, Points> curve_of(const Points& points, int degree) {
  CurveOf<F, Points> curve(degree);
  copy_points(points, curve);
  return curve;
}

template <class Points, class Weights>
CurveOf<Form::rational, Points> curve_of(const Points& points, const Weights& weights, int degree) {
  require_weights(points, weights);
  CurveOf<Form::rational, Points> curve(degree);
  copy_points(points, curve.points);
  for (int i = 0; i <= degree; ++i) curve.weights[i] = std::ranges::data(weights)[i];
  return curve;
}

template <class Scalar, int Dimension>
std::array<Scalar, static_cast<std::size_t>(Dimension)> as_array(const Point<Scalar, Dimension>& point) {
  std::array<Scalar, static_cast<std::size_t>(Dimension)> result;
  for (int axis = 0; axis < Dimension; ++axis) result[static_cast<std::size_t>(axis)] = point[axis];
  return result;
}

/// The degree, within what the method supports.
template <class Method, class Points>
int degree_for(const Points& points) {
  constexpr bool single = sizeof(ScalarOf<Points>) == sizeof(float);
  constexpr int highest = single ? Method::info.max_degree_float : Method::info.max_degree;
  if constexpr (fixed_degree<Points> != dynamic)
    static_assert(fixed_degree<Points> >= Method::info.min_degree && fixed_degree<Points> <= highest,
                  "the method does not support this degree");
  return degree_of_points(points, Method::info.min_degree, highest);
}

#if defined(FP_FAST_FMA) || defined(__FMA__) || defined(__ARM_FEATURE_FMA) || defined(BEZIERBENCH_SLOW_FMA)
inline constexpr bool warns_of_slow_fma = false;
#else
inline constexpr bool warns_of_slow_fma = true;
#endif
inline void use_of_fma(std::false_type /*warns*/) {}
[[deprecated(
    "bezierbench: this method is fused, and std::fma is a call with these options, several times slower: compile with "
    "the option for your processor (-march=x86-64-v3 on x86) or define BEZIERBENCH_SLOW_FMA")]] inline void
use_of_fma(std::true_type /*warns*/) {}

/// Warns where a fused method is named that the compiler's options make slow.
template <class Method>
void warn_of_slow_fma() {
  use_of_fma(std::bool_constant<(Method::info.fused && warns_of_slow_fma)>{});
}

/// Prepares and evaluates.
template <class Method, class C, class Scalar>
auto point_of(const C& curve, const Scalar& t) {
  return as_array(Method::evaluate(Method::prepare(curve), t));
}

/// Whether a method that is chosen at run time can be instantiated for these points.
template <class Method, class Points>
inline constexpr bool may_be_chosen = fixed_degree<Points> == dynamic ||
                                      Method::info.template supports<ScalarOf<Points>>(fixed_degree<Points>);

}  // namespace detail

/// A curve that is prepared once, for many points.
template <Evaluator Method, ControlPoints Points>
class PreparedCurve {
 public:
  using Scalar = ScalarOf<Points>;

  explicit PreparedCurve(const Points& points)
      : state_(Method::prepare(detail::curve_of<Method::info.form>(points, detail::degree_for<Method>(points)))) {
    detail::warn_of_slow_fma<Method>();
  }

  /// The point at t.
  [[nodiscard]] PointOf<Points> operator()(const Scalar& t) const {
    return detail::as_array(Method::evaluate(state_, t));
  }

 private:
  using State = PreparedOf<Method, Scalar, detail::dimension_of_points<Points>, detail::fixed_degree<Points>>;
  State state_;
};

/// Prepares a curve in the form of the method: `const auto curve = prepare<HornerBernstein>(points); curve(t)`.
template <Evaluator Method, ControlPoints Points>
requires(Method::info.form != Form::rational) PreparedCurve<Method, Points> prepare(const Points& points) {
  return PreparedCurve<Method, Points>(points);
}

/// The point at t by a method that is named, of a curve in its form: `points` are control points or, for a method in
/// power form, coefficients, ascending. Throws std::invalid_argument for no points, or a degree that the method does
/// not support.
template <Evaluator Method, ControlPoints Points>
requires(Method::info.form !=
         Form::rational) PointOf<Points> evaluate(const Points& points,
                                                  const std::type_identity_t<ScalarOf<Points>>& t) {
  detail::warn_of_slow_fma<Method>();
  return detail::point_of<Method>(detail::curve_of<Method::info.form>(points, detail::degree_for<Method>(points)), t);
}

/// The same for a rational curve: its control points, not premultiplied, and a weight for each.
template <Evaluator Method, ControlPoints Points, WeightsOf<Points> Weights>
requires(Method::info.form ==
         Form::rational) PointOf<Points> evaluate(const Points& points, const Weights& weights,
                                                  const std::type_identity_t<ScalarOf<Points>>& t) {
  detail::warn_of_slow_fma<Method>();
  return detail::point_of<Method>(detail::curve_of(points, weights, detail::degree_for<Method>(points)), t);
}

/// The point at t by the method that is recommended for the form, the degree and the type; core/api/recommended.hpp has
/// the rule, with the committed tables that it rests on. `recommended` says which method it is and `error_bound` how
/// far the result may be from the true point. Control points so large that C(n,i) b_i overflows need a triangle by
/// name, such as DeCasteljau. Throws std::invalid_argument for no points, or more than max_degree + 1.
template <Form F, ControlPoints Points>
requires(F == Form::bernstein ||
         F == Form::power) PointOf<Points> evaluate(const Points& points,
                                                    const std::type_identity_t<ScalarOf<Points>>& t) {
  const int degree = degree_of_points(points);
  const auto curve = detail::curve_of<F>(points, degree);
  return detail::with_recommended<F, ScalarOf<Points>>(degree, [&]<class Method>() -> PointOf<Points> {
    if constexpr (detail::may_be_chosen<Method, Points>) return detail::point_of<Method>(curve, t);
    return {};
  });
}
template <ControlPoints Points>
PointOf<Points> evaluate(const Points& points, const std::type_identity_t<ScalarOf<Points>>& t) {
  return evaluate<Form::bernstein>(points, t);
}

/// The same for a rational curve: its control points, not premultiplied, and a weight for each.
template <ControlPoints Points, WeightsOf<Points> Weights>
PointOf<Points> evaluate(const Points& points, const Weights& weights,
                         const std::type_identity_t<ScalarOf<Points>>& t) {
  const int degree = degree_of_points(points);
  const auto curve = detail::curve_of(points, weights, degree);
  return detail::with_recommended<Form::rational, ScalarOf<Points>>(degree, [&]<class Method>() -> PointOf<Points> {
    if constexpr (detail::may_be_chosen<Method, Points>) return detail::point_of<Method>(curve, t);
    return {};
  });
}

namespace detail {

/// The amplification at t of coefficients on one axis.
inline double amplification_of(Amplification kind, std::span<const double> coefficients, double t) {
  const bool from_end = anchor_of(kind) == Anchor::nearer_end && t + t > 1;
  const double anchor = anchor_of(kind) == Anchor::none ? 0 : from_end ? coefficients.back() : coefficients.front();
  return amplification(
      kind, static_cast<int>(coefficients.size()) - 1,
      [&](int i) { return std::abs(coefficients[static_cast<std::size_t>(i)] - anchor); }, t);
}

/// The bound of core/bound/error_bound.hpp on one axis, with |p| <= p~, raised by more than its own rounding; the least
/// that the method has.
template <class Scalar>
double bound_on_axis(const ErrorBound& bound, Form form, std::span<const double> coefficients, double t) {
  constexpr double infinite = std::numeric_limits<double>::infinity();
  constexpr bool single = sizeof(Scalar) == sizeof(float);
  constexpr double u = single ? 0x1p-24 : 0x1p-53;
  constexpr double eta = single ? 0x1p-149 : 0x1p-1074;
  if (bound.unit_interval_only && !(t >= 0 && t <= 1)) return infinite;
  const int n = static_cast<int>(coefficients.size()) - 1;
  double largest = 0;
  for (const double value : coefficients) largest = std::max(largest, std::abs(value));
  const bool powers_apart = bound.underflow_scales_with_coefficients;
  const double reach = integer_power(std::abs(t) + std::abs(1 - t), n);
  if (!stays_in_range(bound.growth(n) * (powers_apart ? std::max(largest, 1.0) : largest) * reach, n, u))
    return infinite;
  const double size = bound.result_roundings > 0 ? amplification_of(p_tilde_of(form), coefficients, t) : 0;
  const double rounding =
      (bound.result_roundings * size + bound.factor(n, u) * amplification_of(bound.amplification, coefficients, t)) * u;
  const double underflow = eta * (powers_apart ? 1 + largest : 1) * std::ceil(bound.underflow(n)) * reach;
  const double total = (rounding + underflow) * (1 + 0x1p-20);
  const double first = total >= 0 ? total : infinite;
  return bound.also == nullptr ? first : std::min(first, bound_on_axis<Scalar>(*bound.also, form, coefficients, t));
}

template <class Points>
auto bounds_of(const MethodInfo& info, Form form, const Points& points, double t) {
  using Scalar = ScalarOf<Points>;
  constexpr auto dimension = static_cast<std::size_t>(dimension_of_points<Points>);
  constexpr double u = sizeof(Scalar) == sizeof(float) ? 0x1p-24 : 0x1p-53;
  std::array<double, dimension> result;
  result.fill(std::numeric_limits<double>::infinity());
  if (!info.bound) return result;
  const auto count = static_cast<std::size_t>(degree_of_points(points)) + 1;
  std::array<double, max_degree + 1> room;
  const std::span<const double> coefficients(room.data(), count);
  for (std::size_t axis = 0; axis < dimension; ++axis) {
    for (std::size_t i = 0; i < count; ++i) room[i] = static_cast<double>(std::ranges::data(points)[i][axis]);
    LocalOrNot kinds{.may_be_other = info.bound->of_local == nullptr};
    if (!kinds.may_be_other) {
      const int n = static_cast<int>(count) - 1;
      kinds.add(locality(n, [&](int i) { return coefficients[static_cast<std::size_t>(i)]; }), n, u);
    }
    result[axis] =
        std::max(kinds.may_be_local ? bound_on_axis<Scalar>(*info.bound->of_local, form, coefficients, t) : 0,
                 kinds.may_be_other ? bound_on_axis<Scalar>(*info.bound, form, coefficients, t) : 0);
  }
  return result;
}

}  // namespace detail

/// How far each coordinate of `evaluate<Method>(points, t)` may be from the true one: the method's proved bound at
/// this curve and t, as a distance on each axis. Infinite where nothing is proved, so also where a result on the way
/// may overflow. It holds in arithmetic that rounds each operation once (core/api/floating_point.hpp).
template <Evaluator Method, ControlPoints Points>
requires(Method::info.form != Form::rational &&
         MeasuredPoints<Points>) auto error_bound(const Points& points, std::type_identity_t<ScalarOf<Points>> t) {
  return detail::bounds_of(Method::info, Method::info.form, points, static_cast<double>(t));
}

/// The same for `evaluate<F>(points, t)` and for `evaluate(points, t)`.
template <Form F, ControlPoints Points>
requires((F == Form::bernstein || F == Form::power) &&
         MeasuredPoints<Points>) auto error_bound(const Points& points, std::type_identity_t<ScalarOf<Points>> t) {
  return detail::bounds_of(recommended<F, ScalarOf<Points>>(degree_of_points(points)), F, points,
                           static_cast<double>(t));
}
template <ControlPoints Points>
requires(MeasuredPoints<Points>) auto error_bound(const Points& points, std::type_identity_t<ScalarOf<Points>> t) {
  return error_bound<Form::bernstein>(points, t);
}

}  // namespace bezierbench
