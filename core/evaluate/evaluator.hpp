// SPDX-License-Identifier: MIT
// The concept of an evaluator: `info`, the work per curve, and the work per point.
#pragma once

#include <concepts>

#include "core/curve.hpp"
#include "core/method.hpp"

namespace bezierbench {

/// `prepare` does all per-curve work and returns everything that `evaluate` needs; `evaluate` is pure and neither
/// allocates, prints nor throws. Both are templated on scalar, dimension and degree (fixed or dynamic).
template <class E>
concept Evaluator = requires(const Curve<E::info.form, double, 2>& curve, double t) {
  requires E::info.problem == Problem::evaluation;
  { E::evaluate(E::prepare(curve), t) } -> std::same_as<Point<double, 2>>;
};

/// The type of the prepared state of an evaluator.
template <class E, class Scalar, int Dimension, int Degree = dynamic>
using PreparedOf = decltype(E::prepare(std::declval<const Curve<E::info.form, Scalar, Dimension, Degree>&>()));

}  // namespace bezierbench
