// SPDX-License-Identifier: MIT
// The concept of an evaluator: `info`, the work per curve, and the work per point.
#pragma once

#include <concepts>
#include <type_traits>
#include <utility>

#include "core/curve.hpp"
#include "core/method.hpp"
#include "core/vector/same_for_every_axis.hpp"

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

/// The base of evaluators that prepare nothing: their state is the curve as it is given.
template <Form F>
struct TakenAsGiven {
  template <class Scalar, int Dimension, int Degree>
  static Curve<F, Scalar, Dimension, Degree> prepare(const Curve<F, Scalar, Dimension, Degree>& curve) {
    return curve;
  }
};

template <class E>
concept PreparesNothing = std::is_base_of_v<TakenAsGiven<E::info.form>, E>;

/// Calls `use` with the point as a function of t. A method that chooses by curve passes what it chose, so that a loop
/// over t chooses once.
template <class E, class Prepared, class Use>
void with_evaluation(const Prepared& prepared, const Use& use) {
  if constexpr (requires { E::with_chosen(prepared, use); })
    E::with_chosen(prepared, use);
  else
    use([&prepared](const auto& t) { return E::evaluate(prepared, t); });
}

template <class Scalar, int Degree>
struct PreparedRowType {
  using Type = PerCoefficient<Scalar, Degree>;
};

/// One value per coefficient in a prepared state: a row, or a view of one where a scalar is the axes of a point.
template <class Scalar, int Degree>
using PreparedRow = typename PreparedRowType<Scalar, Degree>::Type;

/// A copy of coefficients, or of values that belong to them, which a method may overwrite.
template <Form F, class Scalar, int Dimension, int Degree>
Curve<F, Scalar, Dimension, computed_degree<Degree>> working_copy(const Curve<F, Scalar, Dimension, Degree>& curve) {
  Curve<F, Scalar, Dimension, computed_degree<Degree>> copy(curve.degree());
  for (int i = 0; i <= curve.degree(); ++i)
    for (int axis = 0; axis < Dimension; ++axis) copy(axis, i) = curve(axis, i);
  return copy;
}
template <int Degree, class Scalar>
PerCoefficient<Scalar, Degree> working_copy(const PerCoefficient<Scalar, Degree>& row, int /*degree*/) {
  return row;
}

}  // namespace bezierbench
