// SPDX-License-Identifier: MIT
// The concept of an evaluator: `info`, the work per curve, and the work per point.
#pragma once

#include <concepts>
#include <type_traits>
#include <utility>

#include "core/curve.hpp"
#include "core/method.hpp"
#include "core/vector/same_for_every_axis.hpp"
#include "core/vector/shared.hpp"
#include "core/vector/view.hpp"

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

namespace detail {

template <class Scalar, class Number, int Degree>
struct RowType {
  using Type = PerCoefficient<Number, Degree>;
};
template <ReadsCurves V, class Number, int Degree>
struct RowType<V, Number, Degree> {
  using Type = Row<V>;
};

}  // namespace detail

/// One value per coefficient in a prepared state: a row, or a view of one.
template <class Scalar, int Degree>
using PreparedRow = typename detail::RowType<Scalar, Scalar, Degree>::Type;

/// A row of values that all curves of a degree share, or a view of one.
template <class Scalar, int Degree>
using SharedRow = typename detail::RowType<Scalar, SharedBy<Scalar>, Degree>::Type;

/// How many vectors an evaluator keeps in registers where a scalar is many lanes: for each axis of a point, and in
/// addition to those. From these follows how many vectors of points go side by side. An evaluator with kernels for
/// lanes has a member `lanes` of this type. The numbers may be understated on purpose: where divisions or memory take
/// the time, and for Horner-Bernstein, whose t and 1-t are only read and may come from memory (a tenth faster on AVX2).
struct LaneRegisters {
  int per_axis;
  int shared;
  /// Degrees from 2 to this have kernels of their own, for one curve. Each degree takes a second to compile.
  int largest_fixed_degree = 0;
  /// True without kernels for many curves: where `evaluate` comes back to single lanes, where curves have weights, and
  /// where `prepare` is not written for lanes.
  bool one_curve_only = false;
};

/// A copy of a curve, which a method may overwrite.
template <Form F, class Scalar, int Dimension, int Degree>
Curve<F, Scalar, Dimension, computed_degree<Degree>> working_copy(const Curve<F, Scalar, Dimension, Degree>& curve) {
  Curve<F, Scalar, Dimension, computed_degree<Degree>> copy(curve.degree());
  for (int i = 0; i <= curve.degree(); ++i)
    for (int axis = 0; axis < Dimension; ++axis) copy(axis, i) = curve(axis, i);
  return copy;
}
template <Form F, ReadsCurves V, int Dimension, int Degree>
CopyOfView<V, Dimension, Degree> working_copy(const Curve<F, V, Dimension, Degree>& curve) {
  CopyOfView<V, Dimension, Degree> copy;
  for (int i = 0; i <= curve.degree(); ++i)
    for (int axis = 0; axis < Dimension; ++axis) copy(axis, i) = curve(axis, i);
  return copy;
}

}  // namespace bezierbench
