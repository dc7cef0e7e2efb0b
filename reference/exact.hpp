// SPDX-License-Identifier: MIT
// The true point of a curve, from big integers, rounded once:
//
//   std::vector<std::array<double, 2>> points{{0, 0}, {1, 2}, {3, 1}};
//   std::array<double, 2> p = bezierbench::exact(points, 0.1);
//
// The curve and t are taken as the numbers that they are: every double is a fraction. A point takes microseconds.
#pragma once

#include <algorithm>
#include <type_traits>
#include <vector>

#include "core/api/control_points.hpp"

namespace bezierbench {

namespace reference {

/// The coordinates of the point at t, each the double nearest to it (ties to even), or with `single` the float; NaN
/// where a rational curve has no point. Throws std::invalid_argument for a number that is not finite.
void exact_coordinates(const CurveView<double>& curve, double t, bool single, std::span<double> result);

/// |value - true coordinate| of each coordinate, the double nearest to it; infinite for a value that is not finite.
void exact_distances(const CurveView<double>& curve, double t, std::span<const double> values,
                     std::span<double> result);

/// A curve as doubles, which hold every float.
template <ControlPoints Points>
struct ExactInput {
  static constexpr std::size_t dimension = std::tuple_size_v<PointOf<Points>>;
  static constexpr bool single = std::is_same_v<ScalarOf<Points>, float>;

  explicit ExactInput(const Points& points) : degree(degree_of_points(points)) {
    for (const auto& point : points)
      for (const auto coordinate : point) coefficients.push_back(static_cast<double>(coordinate));
  }
  template <WeightsOf<Points> Weights>
  ExactInput(const Points& points, const Weights& point_weights) : ExactInput(points) {
    require_weights(points, point_weights);
    for (const auto weight : point_weights) weights.push_back(static_cast<double>(weight));
  }

  [[nodiscard]] CurveView<double> view(Form form) const {
    return {form, static_cast<int>(dimension), degree, coefficients, weights};
  }
  [[nodiscard]] PointOf<Points> point(Form form, double t) const {
    std::array<double, dimension> coordinates;
    exact_coordinates(view(form), t, single, coordinates);
    PointOf<Points> result;
    for (std::size_t axis = 0; axis < dimension; ++axis)
      result[axis] = static_cast<ScalarOf<Points>>(coordinates[axis]);  // exactly: it was rounded to this type
    return result;
  }
  [[nodiscard]] std::array<double, dimension> distances(Form form, double t, const PointOf<Points>& value) const {
    std::array<double, dimension> values;
    std::copy(value.begin(), value.end(), values.begin());
    std::array<double, dimension> result;
    exact_distances(view(form), t, values, result);
    return result;
  }

  int degree;
  std::vector<double> coefficients;
  std::vector<double> weights;
};

}  // namespace reference

/// The true point at any finite t, each coordinate the nearest number of its type, ties to even. `F` is the form of the
/// points: Form::bernstein (control points) or Form::power (coefficients, ascending). Throws std::invalid_argument for
/// no points, too many, or a number that is not finite.
template <Form F = Form::bernstein, ControlPoints Points>
requires((F == Form::bernstein || F == Form::power) &&
         MeasuredPoints<Points>) PointOf<Points> exact(const Points& points, std::type_identity_t<ScalarOf<Points>> t) {
  return reference::ExactInput<Points>(points).point(F, static_cast<double>(t));
}

/// The same for a rational curve: its control points, not premultiplied, and a weight for each. NaN where the weights
/// sum to zero at t.
template <ControlPoints Points, WeightsOf<Points> Weights>
requires(MeasuredPoints<Points>) PointOf<Points> exact(const Points& points, const Weights& weights,
                                                       std::type_identity_t<ScalarOf<Points>> t) {
  return reference::ExactInput<Points>(points, weights).point(Form::rational, static_cast<double>(t));
}

/// How far each coordinate of `value` is from the true point: |value - true|, rounded once, to double.
template <Form F = Form::bernstein, ControlPoints Points>
requires((F == Form::bernstein || F == Form::power) &&
         MeasuredPoints<Points>) auto exact_error(const Points& points, std::type_identity_t<ScalarOf<Points>> t,
                                                  const PointOf<Points>& value) {
  return reference::ExactInput<Points>(points).distances(F, static_cast<double>(t), value);
}

/// The same for a rational curve.
template <ControlPoints Points, WeightsOf<Points> Weights>
requires(MeasuredPoints<Points>) auto exact_error(const Points& points, const Weights& weights,
                                                  std::type_identity_t<ScalarOf<Points>> t,
                                                  const PointOf<Points>& value) {
  return reference::ExactInput<Points>(points, weights).distances(Form::rational, static_cast<double>(t), value);
}

}  // namespace bezierbench
