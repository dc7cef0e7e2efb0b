// SPDX-License-Identifier: MIT
// A rational B-spline curve (NURBS) is a polynomial one in homogeneous coordinates: (w_i d_i, w_i), the last one
// divides the others.
//
// Bound, for weights > 0: docs/proofs/homogeneous.md; of a weight of the Bernstein form that of the polynomial method.
// Fails: w_i d_i overflows or underflows where d_i would not; with weights of both signs W may cancel.
#pragma once

#include "core/bspline/bspline.hpp"
#include "core/evaluate/joined.hpp"

namespace bezierbench {

/// `Method` on homogeneous coordinates. It keeps its id and has the rational form.
template <class Method>
requires(BsplineEvaluator<Method> || BsplineConversion<Method>) struct HomogeneousSpan {
  using Polynomial = Method;

  struct BoundText {
    static constexpr std::string_view text = Method::info.promise;
  };
  struct BoundPrefix {
    static constexpr std::string_view text = BoundText::text.empty() ? "" : "numerator and denominator: ";
  };
  static constexpr MethodInfo info{
      .id = Method::info.id,
      .label = detail::Joined<detail::LabelOf<Method>, detail::Literal<", homogeneous">>::text,
      .problem = Problem::bspline,
      .form = Form::rational,
      .min_degree = Method::info.min_degree,
      .promise = detail::Joined<BoundPrefix, BoundText>::text,
      .flops = detail::Joined<detail::FlopsOf<Method>, detail::Literal<" with d + 1 for d; d divisions">>::text,
      .cost_exponent = Method::info.cost_exponent,
      .prepare_exponent = Method::info.prepare_exponent,
      .citation =
          detail::Joined<detail::CitationOf<Method>, detail::Literal<"; [Piegl and Tiller 1997], section 4.2">>::text};
};

}  // namespace bezierbench
