// SPDX-License-Identifier: MIT
// The concept of a method for derivatives: `info`, a function for the work per curve and order, and one for the work
// per point.
#pragma once

#include <concepts>

#include "core/bound/derivative_bound.hpp"
#include "core/curve.hpp"
#include "core/method.hpp"

namespace bezierbench {

/// `prepare(curve, order)` does all work that does not depend on t, for any order >= 0. `evaluate` returns the
/// derivative of that order at t: the point itself for order 0, and 0 for orders beyond the degree. A method with a
/// proved bound has a `DerivativeBound bound`.
template <class M>
concept DerivativeMethod = requires(const Curve<M::info.form, double, 2>& curve, int order, double t) {
  requires M::info.problem == Problem::derivative;
  { M::evaluate(M::prepare(curve, order), t) } -> std::same_as<Point<double, 2>>;
};

/// `all(curve, last_order, t, take)` calls take(k, C^(k)(t)) once for every order k from 0 to `last_order`, in any
/// sequence, with work that the orders share; each keeps the bound of its order.
template <class M>
concept AllOrdersMethod = DerivativeMethod<M> && requires(const Curve<M::info.form, double, 2>& curve, int last_order,
                                                          double t, void (*take)(int, const Point<double, 2>&)) {
  M::all(curve, last_order, t, take);
};

/// What a method whose work is all per point has of a curve.
template <Form F, int Dimension>
struct CurveAndOrder {
  Curve<F, double, Dimension> curve;
  int order;
};

}  // namespace bezierbench
