// SPDX-License-Identifier: MIT
// A Bezier curve as chords within a tolerance, in one call:
//
//   std::vector<std::array<double, 2>> points{{0, 0}, {1, 2}, {3, 1}};
//   std::vector<std::array<double, 2>> ends = bezierbench::flatten(points, 0.01);
//
// With weights after the points the curve is rational: `flatten(points, weights, 0.01)`. The methods are in
// core/flatten; `flatten<Levien>(points, 0.01)` names one.
#pragma once

#include <cmath>
#include <stdexcept>
#include <vector>

#include "core/api/evaluate.hpp"
#include "core/flatten/roster.hpp"
#include "core/flatten/scaled.hpp"

namespace bezierbench {

namespace detail {

template <class Method, class Points, class C>
std::vector<PointOf<Points>> chords_of(const C& curve, double tolerance) {
  if (!(tolerance > 0 && std::isfinite(tolerance)))
    throw std::invalid_argument("bezierbench: the tolerance must be above 0");
  Flattening chords;
  flatten_scaled<Method>(curve, tolerance, chords);
  if (!chords.complete) throw std::invalid_argument("bezierbench: the tolerance is too fine for the coordinates");
  std::vector<PointOf<Points>> ends(chords.t.size());
  const double* coordinate = chords.points.data();
  for (auto& end : ends)
    for (auto& x : end) x = *coordinate++;
  return ends;
}

}  // namespace detail

/// The ends of the chords by a method, in order; the first and the last are those of the curve. Throws
/// std::invalid_argument for a degree that the method does not take, a tolerance that is not above 0, and where the
/// method says that it did not keep the tolerance.
template <FlattenMethod Method, ControlPoints Points>
requires std::is_same_v < ScalarOf<Points>,
double > std::vector<PointOf<Points>> flatten(const Points& points, double tolerance) {
  return detail::chords_of<Method, Points>(
      detail::curve_of<Form::bernstein>(points, detail::degree_for<Method>(points)), tolerance);
}

/// Those of a rational curve with one weight for each point, by halving in homogeneous coordinates if no method is
/// named. Throws std::invalid_argument for another number of weights, too.
template <FlattenMethod Method = Halving<DistanceCriterion, Form::rational>, ControlPoints Points, class Weights>
requires std::is_same_v < ScalarOf<Points>,
double > std::vector<PointOf<Points>> flatten(const Points& points, const Weights& weights, double tolerance) {
  return detail::chords_of<Method, Points>(detail::curve_of(points, weights, detail::degree_for<Method>(points)),
                                           tolerance);
}

/// The same, by the method with the fewest chords that promises the tolerance: EqualErrors up to degree 3, halving
/// above.
template <ControlPoints Points>
requires std::is_same_v < ScalarOf<Points>,
double > std::vector<PointOf<Points>> flatten(const Points& points, double tolerance) {
  if constexpr (detail::fixed_degree<Points> != dynamic) {
    if constexpr (detail::fixed_degree<Points> <= EqualErrors::info.max_degree)
      return flatten<EqualErrors>(points, tolerance);
    else
      return flatten<Halving<DistanceCriterion>>(points, tolerance);
  } else {
    return std::ranges::size(points) <= static_cast<std::size_t>(EqualErrors::info.max_degree) + 1
               ? flatten<EqualErrors>(points, tolerance)
               : flatten<Halving<DistanceCriterion>>(points, tolerance);
  }
}

}  // namespace bezierbench
