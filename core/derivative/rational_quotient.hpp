// SPDX-License-Identifier: MIT
// Formula: with A = sum w_i b_i B_i and W = sum w_i B_i, C^(k) = (A^(k) - sum_(i=1..k) C(k,i) W^(i) C^(k-i)) / W. The
//   derivatives of (A, W) are those of a polynomial curve in homogeneous coordinates, by `Method`. If `is_local`, the
//   control points are taken about the nearer end of the curve, b_0 or b_n, which is added to the point again.
// Source: about the nearer end: derived here, from C^(k) being the same for translated control points.
// Cost: if local, d(n+1) subtractions more.
// Bound: (k+1) s / (1 - (k+1) s) S_k, where s and S_k are those of core/bound/derivative_bound.hpp; the proof is in
//   docs/proofs/rational_derivative.md. None for the local one.
// Fails: far from the origin, where A^(k) and the sum cancel by the ratio of distance to size; the local one does not.
//   Where W vanishes or is nearly 0. Above order 1023, where it is not a number.
#pragma once

#include "core/binomial.hpp"
#include "core/derivative/derivative.hpp"
#include "core/evaluate/joined.hpp"

namespace bezierbench {

template <AllOrdersMethod Method, bool is_local>
struct RationalQuotient {
  struct IdPrefix {
    static constexpr std::string_view text = is_local ? "local:" : "";
  };
  struct LabelSuffix {
    static constexpr std::string_view text = is_local ? ", quotient about the nearer end" : ", quotient";
  };
  struct PromiseOf {
    static constexpr std::string_view text = Method::bound.text;
  };
  struct FlopsOfAll {
    static constexpr std::string_view text = Method::flops_of_all;
  };
  struct FlopsSuffix {
    static constexpr std::string_view text = is_local
                                                 ? " with d + 1 for d; d((k+1)(2k+1) + n + 2), d(k+1) of them divisions"
                                                 : " with d + 1 for d; d((k+1)(2k+1) + 1), d(k+1) of them divisions";
  };

  static constexpr DerivativeBound polynomial_bound = Method::bound;
  static constexpr MethodInfo info = [] {
    MethodInfo composed = Method::info;
    composed.id = detail::Joined<IdPrefix, detail::IdOf<Method>>::text;
    composed.label = detail::Joined<detail::LabelOf<Method>, LabelSuffix>::text;
    composed.form = Form::rational;
    composed.promise =
        is_local ? std::string_view() : detail::Joined<detail::Literal<"numerator and denominator: ">, PromiseOf>::text;
    composed.flops = detail::Joined<FlopsOfAll, FlopsSuffix>::text;
    composed.cost_exponent = 2;
    composed.prepare_exponent = 1;
    composed.citation =
        detail::Joined<detail::CitationOf<Method>, detail::Literal<"; [Piegl and Tiller 1997], eq. (4.8)">>::text;
    return composed;
  }();

  template <int Dimension>
  static CurveAndOrder<Form::rational, Dimension> prepare(const Curve<Form::rational, double, Dimension>& curve,
                                                          int order) {
    return {curve, order};
  }

  template <int Dimension>
  static Point<double, Dimension> evaluate(const CurveAndOrder<Form::rational, Dimension>& prepared, double t) {
    const int order = prepared.order;
    if (order > max_degree) return Point<double, Dimension>::Constant(std::numeric_limits<double>::quiet_NaN());
    const auto& points = prepared.curve.points;
    const auto& weights = prepared.curve.weights;
    const int n = prepared.curve.degree();
    const int anchor = t <= 0.5 ? 0 : n;
    Curve<Form::bernstein, double, Dimension + 1> lifted(n);
    for (int i = 0; i <= n; ++i) {
      for (int axis = 0; axis < Dimension; ++axis)
        lifted(axis, i) = weights[i] * (is_local ? points(axis, i) - points(axis, anchor) : points(axis, i));
      lifted(Dimension, i) = weights[i];
    }
    Curve<Form::bernstein, double, Dimension + 1> derivatives(order);  // of (A, W); A becomes C
    for (int k = n + 1; k <= order; ++k)
      for (int axis = 0; axis <= Dimension; ++axis) derivatives(axis, k) = 0;
    Method::all(lifted, std::min(order, n), t, [&derivatives](int k, const Point<double, Dimension + 1>& derivative) {
      for (int axis = 0; axis <= Dimension; ++axis) derivatives(axis, k) = derivative[axis];
    });
    for (int k = 0; k <= order; ++k) {
      const BinomialRow<double, dynamic> binomials(k);
      for (int axis = 0; axis < Dimension; ++axis) {
        double sum = derivatives(axis, k);
        for (int i = 1; i <= k; ++i) sum -= binomials[i] * derivatives(Dimension, i) * derivatives(axis, k - i);
        derivatives(axis, k) = sum / derivatives(Dimension, 0);
      }
    }
    Point<double, Dimension> result;
    for (int axis = 0; axis < Dimension; ++axis)
      result[axis] = is_local && order == 0 ? derivatives(axis, 0) + points(axis, anchor) : derivatives(axis, order);
    return result;
  }
};

}  // namespace bezierbench
