// SPDX-License-Identifier: MIT
// Formula: the point and all derivatives up to the order, in one call of the method `M`; the last of them is the
//   result, with its bits and its error. Preparation is part of the call, so only the time differs.
// Bound: that of `M`.
// Fails: where `M` does.
#pragma once

#include <algorithm>

#include "core/derivative/derivative.hpp"
#include "core/evaluate/joined.hpp"

namespace bezierbench {

template <AllOrdersMethod M>
struct AllOrders {
  static constexpr DerivativeBound bound = M::bound;
  static constexpr MethodInfo info = [] {
    MethodInfo composed = M::info;
    composed.id = detail::Joined<detail::Literal<"all_orders_">, detail::IdOf<M>>::text;
    composed.label = detail::Joined<detail::Literal<"All orders in one call: ">, detail::LabelOf<M>>::text;
    composed.flops = M::flops_of_all;
    composed.prepare_exponent = 1;
    return composed;
  }();

  template <int Dimension>
  static CurveAndOrder<info.form, Dimension> prepare(const Curve<info.form, double, Dimension>& curve, int order) {
    return {curve, order};
  }

  /// Keeps the results of all orders within the degree, as a caller of `all` does.
  template <int Dimension>
  static Point<double, Dimension> evaluate(const CurveAndOrder<info.form, Dimension>& prepared, double t) {
    const int n = prepared.curve.degree();
    const int last = std::min(prepared.order, n);
    Curve<info.form, double, Dimension> results(last);
    M::all(prepared.curve, last, t, [&results](int k, const Point<double, Dimension>& derivative) {
      for (int axis = 0; axis < Dimension; ++axis) results(axis, k) = derivative[axis];
    });
    Point<double, Dimension> result;
    for (int axis = 0; axis < Dimension; ++axis) result[axis] = prepared.order > n ? 0 : results(axis, last);
    return result;
  }
};

}  // namespace bezierbench
