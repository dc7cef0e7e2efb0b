// SPDX-License-Identifier: MIT
// A box that surely contains a Bezier curve, in one call:
//
//   std::vector<std::array<double, 2>> points{{0, 0}, {1, 2}, {3, 1}};
//   std::array<bezierbench::Range, 2> sides = bezierbench::box(points);
//
// The methods are in core/bounds; `box<ExactBox<Form::bernstein>>(points)` names one. ExactBox needs the compiled part
// of the package; the others are headers alone.
#pragma once

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "core/api/evaluate.hpp"
#include "core/bounds/roster.hpp"

namespace bezierbench {

/// A box: the range of each axis.
template <ControlPoints Points>
using BoxOf = std::array<Range, detail::array_size<PointOf<Points>>>;

namespace detail {

/// Sets the coordinates of each axis in turn, and calls `range` for it.
template <class Points, class Find>
BoxOf<Points> range_of_each_axis(const Points& points, PolynomialAxis& axis, const Find& find) {
  BoxOf<Points> box;
  for (std::size_t place = 0; place < box.size(); ++place) {
    for (int i = 0; i <= axis.degree(); ++i) {
      axis(0, i) = std::ranges::data(points)[i][place];
      if (!std::isfinite(axis(0, i))) throw std::invalid_argument("bezierbench: control points must be finite");
    }
    box[place] = find();
  }
  return box;
}

}  // namespace detail

/// The box by a method; `Method::promises` says what is proved of it. Throws std::invalid_argument for a degree that
/// the method does not take, and for numbers that are not finite.
template <BoundsMethod Method, ControlPoints Points>
requires(Method::info.form == Form::bernstein &&
         std::is_same_v<ScalarOf<Points>, double>) BoxOf<Points> box(const Points& points) {
  PolynomialAxis axis(detail::degree_for<Method>(points));
  return detail::range_of_each_axis(points, axis, [&] { return Method::range(axis); });
}

/// The same for a rational curve: its control points, not premultiplied, and a weight for each. Weights of both signs
/// give infinite sides; those of which all are 0 are refused.
template <BoundsMethod Method, ControlPoints Points, WeightsOf<Points> Weights>
requires(Method::info.form == Form::rational &&
         std::is_same_v<ScalarOf<Points>, double>) BoxOf<Points> box(const Points& points, const Weights& weights) {
  require_weights(points, weights);
  RationalAxis axis(detail::degree_for<Method>(points));
  for (int i = 0; i <= axis.degree(); ++i) axis.weights[i] = std::ranges::data(weights)[i];
  if (!axis.weights.allFinite() || axis.weights.isZero(0))
    throw std::invalid_argument("bezierbench: weights must be finite, and not all 0");
  return detail::range_of_each_axis(points, axis.points, [&] { return Method::range(axis); });
}

/// The box by SplitBox, which contains the curve.
template <ControlPoints Points>
requires std::is_same_v < ScalarOf<Points>,
double > BoxOf<Points> box(const Points& points) { return box<SplitBox>(points); }

/// The box by ExactBox, which contains the curve and has each side at most 1 ulp beyond the tightest one.
template <ControlPoints Points, WeightsOf<Points> Weights>
requires std::is_same_v < ScalarOf<Points>,
double > BoxOf<Points> box(const Points& points, const Weights& weights) {
  return box<ExactBox<Form::rational>>(points, weights);
}

}  // namespace bezierbench
