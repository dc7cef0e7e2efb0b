// SPDX-License-Identifier: MIT
// Formula: a rational curve is a polynomial one in homogeneous coordinates (w_i b_i, w_i). The polynomial method
//   evaluates these; the last coordinate divides the others.
// Bound: (1 + u)^2 (1 + phi) / (1 - phi) - 1 times p~, for weights >= 0 and 0 <= t <= 1, with phi = factor u of the
//   polynomial method; the proof, with underflow, is in docs/proofs/homogeneous.md. Where that states no bound, none
//   follows.
// Fails: w_i b_i overflows or underflows where b_i would not. Outside [0,1] or with weights of both signs W may cancel.
#pragma once

#include <limits>

#include "core/evaluate/joined.hpp"
#include "core/homogeneous_coordinates.hpp"

namespace bezierbench {

/// The point with these homogeneous coordinates: the last divides the others.
template <class Scalar, int Lifted>
Point<Scalar, Lifted - 1> over_last(const Point<Scalar, Lifted>& lifted) {
  Point<Scalar, Lifted - 1> point;
  for (int axis = 0; axis + 1 < Lifted; ++axis) point[axis] = lifted[axis] / lifted[Lifted - 1];
  return point;
}

/// Of one vector, in whose last lane the division leaves a number that nothing reads.
template <class V>
requires(V::axes > 1) Point<V, 1> over_last(const Point<V, 1>& lifted) {
  return Point<V, 1>(lifted[0] / V(lifted[0].lane(V::axes - 1)));
}

/// Has the member `largest_fixed_degree` if the method declares one, and no member if it does not.
template <class Method>
struct FixedDegreesOf {};
template <class Method>
requires requires { Method::largest_fixed_degree; }
struct FixedDegreesOf<Method> {
  static constexpr int largest_fixed_degree = Method::largest_fixed_degree;
};

/// `Method` on homogeneous coordinates; keeps its id, in the rational form.
template <Evaluator Method>
requires(Method::info.form == Form::bernstein) struct Homogeneous : FixedDegreesOf<Method> {
  static constexpr double bound_factor(int n, double u) {
    const double factor = Method::info.bound->factor(n, u);
    const double phi = factor * u;
    if (!(phi <= 0.125)) return std::numeric_limits<double>::infinity();
    return (2 * factor + (2 + u) * (1 + phi)) / (1 - phi);
  }
  /// The underflow of the polynomial method and, for each product w_i b_i, half a unit more.
  static constexpr double bound_underflow(int n) { return 2 * Method::info.bound->underflow(n) + 1; }

  static constexpr std::optional<ErrorBound> bound() {
    if constexpr (Method::info.bound && Method::info.bound->amplification == Amplification::p_tilde_bernstein &&
                  Method::info.bound->result_roundings == 0)
      return ErrorBound{
          .text = detail::Joined<detail::Literal<"numerator and denominator: ">, detail::BoundOf<Method>>::text,
          .amplification = Amplification::p_tilde_bernstein,
          .factor = bound_factor,
          .underflow = bound_underflow,
          .underflow_scales_with_coefficients = Method::info.bound->underflow_scales_with_coefficients,
          .growth = Method::info.bound->growth,
          .unit_interval_only = true};
    else
      return std::nullopt;
  }

  static constexpr MethodInfo info{
      .id = Method::info.id,
      .label = detail::Joined<detail::LabelOf<Method>, detail::Literal<", homogeneous">>::text,
      .form = Form::rational,
      .min_degree = Method::info.min_degree,
      .max_degree = Method::info.max_degree,
      .max_degree_float = Method::info.max_degree_float,
      .unit_interval_only = Method::info.unit_interval_only,
      .bound = bound(),
      .bit_stable = Method::info.bit_stable,
      .fused = Method::info.fused,
      .one_minus_t = Method::info.one_minus_t,
      .flops = detail::Joined<detail::FlopsOf<Method>, detail::Literal<" with d + 1 for d; d divisions">>::text,
      .cost_exponent = Method::info.cost_exponent,
      .prepare_exponent = Method::info.prepare_exponent,
      .citation = detail::Joined<detail::CitationOf<Method>, detail::Literal<"; [Farin 1983]">>::text};

  template <class Scalar, int Dimension, int Degree>
  static auto prepare(const Curve<Form::rational, Scalar, Dimension, Degree>& curve) {
    return Method::prepare(homogeneous(curve));
  }

  template <class Prepared, class Scalar>
  static auto evaluate(const Prepared& prepared, Scalar t) {
    return over_last(Method::evaluate(prepared, t));
  }
};

}  // namespace bezierbench
