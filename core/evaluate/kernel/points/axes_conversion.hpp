// SPDX-License-Identifier: MIT
// Converts a curve for all axes of a coefficient at once: the curve as it is read, and what was computed from it as it
// is written.
#pragma once

#include <tuple>

#include "core/evaluate/kernel/points/axes.hpp"
#include "core/vector/view.hpp"

namespace bezierbench {

namespace instantiate {

template <Form F, int Dimension, class Scalar>
Curve<F, Axes<Scalar, Dimension, Held::by_value>, 1, viewed> axes_of(const CurveView<Scalar>& view) {
  return {view.coefficients.data(), view.degree};
}

/// A copy of a curve of this degree, whose coefficients a compiler can keep in registers.
template <Form F, int Dimension, int Degree, class Scalar>
Curve<F, Axes<Scalar, Dimension, Held::by_value>, 1, Degree> axes_of_degree(const CurveView<Scalar>& view) {
  using Coefficient = Axes<Scalar, Dimension, Held::by_value>;
  Curve<F, Coefficient, 1, Degree> curve(Degree);
  for (int i = 0; i <= Degree; ++i) curve(0, i) = Coefficient::read(view.coefficients.data() + i * Dimension);
  return curve;
}

/// The coefficients of a curve whose axes are one scalar, written point by point as they are read afterwards.
template <int Dimension, Form F, class Scalar>
Curve<F, Scalar, Dimension> as_points(const Curve<F, Axes<Scalar, Dimension, Held::by_value>, 1>& curve) {
  Curve<F, Scalar, Dimension> points(curve.degree());
  for (int i = 0; i <= curve.degree(); ++i) curve(0, i).store(&points(0, i));
  return points;
}
/// Values that all axes share stay as they are.
template <int Dimension, class Scalar>
PerCoefficient<Scalar, dynamic> as_points(const PerCoefficient<Scalar, dynamic>& row) {
  return row;
}
/// For a state of several members, which its function `parts` lists.
template <int Dimension, template <class, int, int> class State, class Scalar>
requires requires(const State<Scalar, Dimension, dynamic>& state) { state.parts(); }
State<Scalar, Dimension, dynamic> as_points(const State<Axes<Scalar, Dimension, Held::by_value>, 1, dynamic>& state) {
  return std::apply(
      [](const auto&... part) { return State<Scalar, Dimension, dynamic>{as_points<Dimension>(part)...}; },
      state.parts());
}

}  // namespace instantiate
}  // namespace bezierbench
