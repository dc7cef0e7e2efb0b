// SPDX-License-Identifier: MIT
// A rational curve is a polynomial one in homogeneous coordinates: split (w_i b_i, w_i), divide by the last one. The
// ends b_0 and b_n are copied, since (w b) / w may be a rounding away from b.
//
// Bound, for weights >= 0 and 0 <= t <= 1: of a weight that of the polynomial method; of a point as derived at
//   split_quotient_bound (core/subdivide/subdivision.hpp), to first order twice the polynomial method's factor and 2.
// Fails: w_i b_i overflows or underflows where b_i would not; a point whose weight is 0 is not finite; outside [0,1] or
//   with weights of both signs a weight may cancel. At t = 0 and 1 the half that is the curve is so to two roundings.
#pragma once

#include "core/evaluate/joined.hpp"
#include "core/homogeneous_coordinates.hpp"
#include "core/subdivide/subdivision.hpp"

namespace bezierbench {

/// `Method` on homogeneous coordinates. It keeps its id and has the rational form.
template <SplitMethod Method>
requires(Method::info.form == Form::bernstein) struct HomogeneousSplit {
  static constexpr SplitBound bound = Method::bound;
  static constexpr SplitPromises promises{.keeps_ends = Method::promises.keeps_ends,
                                          .shares_junction = Method::promises.shares_junction,
                                          .exact_at_zero = false,
                                          .exact_at_one = false,
                                          .reproduces_constants = false,
                                          .mirrors = Method::promises.mirrors};

  struct BoundText {
    static constexpr std::string_view text = Method::bound.text;
  };
  static constexpr MethodInfo info{
      .id = Method::info.id,
      .label = detail::Joined<detail::LabelOf<Method>, detail::Literal<", homogeneous">>::text,
      .problem = Problem::subdivision,
      .form = Form::rational,
      .min_degree = Method::info.min_degree,
      .max_degree = Method::info.max_degree,
      .max_degree_float = Method::info.max_degree_float,
      .promise = detail::Joined<detail::Literal<"numerator and denominator: ">, BoundText>::text,
      .bit_stable = Method::info.bit_stable,
      .one_minus_t = Method::info.one_minus_t,
      .flops = detail::Joined<detail::FlopsOf<Method>, detail::Literal<" with d + 1 for d; 2d(n+1) divisions">>::text,
      .cost_exponent = Method::info.cost_exponent,
      .citation = detail::Joined<detail::CitationOf<Method>, detail::Literal<"; [Farin 1983]">>::text};

  template <class Scalar, int Dimension, int Degree>
  static Halves<Curve<Form::rational, Scalar, Dimension, Degree>> split(
      const Curve<Form::rational, Scalar, Dimension, Degree>& curve, Scalar t) {
    const int n = curve.degree();
    const auto halves = Method::split(homogeneous(curve), t);
    Halves<Curve<Form::rational, Scalar, Dimension, Degree>> result{over_last_axis(halves.left),
                                                                    over_last_axis(halves.right)};
    for (int axis = 0; axis < Dimension; ++axis) {
      result.left.points(axis, 0) = curve.points(axis, 0);
      result.right.points(axis, n) = curve.points(axis, n);
    }
    return result;
  }
};

}  // namespace bezierbench
