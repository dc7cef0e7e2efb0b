// SPDX-License-Identifier: MIT
// The control points of a part of a curve, and of a curve in a higher degree.
#include <algorithm>
#include <cmath>

#include "bindings/c/more_axes.hpp"
#include "reference/companion/exact_split.hpp"

using namespace bezierbench;

namespace {

CurveView<double> with_control_points(const bb_curve* curve) {
  const auto view = c::curve_of(curve);
  c::require(view.form != Form::power, BB_ERROR_FORM);
  return view;
}

/// Before what takes long is computed.
void require_place(const bb_half* to, const CurveView<double>& curve) {
  c::require_pointers(to);
  c::require_pointers(to->points);
  if (curve.form == Form::rational) c::require_pointers(to->weights);
}

void write(const std::optional<reference::RoundedControlPoints>& found, const bb_half* to) {
  c::require(found.has_value(), BB_ERROR_NO_POINT);
  const auto is_finite = [](double x) { return std::isfinite(x); };
  c::require(std::ranges::all_of(found->points, is_finite) && std::ranges::all_of(found->weights, is_finite),
             BB_ERROR_OVERFLOW);
  std::ranges::copy(found->points, to->points);
  std::ranges::copy(found->weights, to->weights);
}

/// Writes the control points of a curve of 4 or 5 axes, `degree` + 1 of them; `answer(some, to)` does those of some axes.
template <class Answer>
void write_by_axes(const bb_curve& curve, int degree, const bb_half* to, const Answer& answer) {
  c::require_pointers(to);
  c::require_pointers(to->points);
  const bool rational = curve.form == BB_RATIONAL;
  if (rational) c::require_pointers(to->weights);
  std::vector<double> weights(static_cast<std::size_t>(degree) + 1);
  c::by_axes(curve, weights.size(), to->points, [&](const bb_curve& some, double* of_some) {
    const bb_half its_points{of_some, weights.data()};
    return answer(some, its_points);
  });
  if (rational) std::ranges::copy(weights, to->weights);
}

}  // namespace

int bb_part(const bb_curve* curve, double from, double to, const bb_half* part) {
  return c::guarded([&] {
    if (c::has_more_axes(curve)) {
      c::require_shape(c::max_dimension, curve->degree);
      return write_by_axes(*curve, curve->degree, part, [&](const bb_curve& some, const bb_half& its_part) {
        return bb_part(&some, from, to, &its_part);
      });
    }
    const auto view = with_control_points(curve);
    c::require(std::isfinite(from) && std::isfinite(to), BB_ERROR_NOT_FINITE);
    require_place(part, view);
    write(reference::control_points_of_part(view, from, to), part);
  });
}

int bb_elevate(const bb_curve* curve, int degree, const bb_half* elevated) {
  return c::guarded([&] {
    if (c::has_more_axes(curve)) {
      c::require(degree >= curve->degree && degree <= max_degree, BB_ERROR_DEGREE);
      return write_by_axes(*curve, degree, elevated, [&](const bb_curve& some, const bb_half& its_points) {
        return bb_elevate(&some, degree, &its_points);
      });
    }
    const auto view = with_control_points(curve);
    c::require(degree >= view.degree && degree <= max_degree, BB_ERROR_DEGREE);
    require_place(elevated, view);
    write(reference::elevated_control_points(view, degree), elevated);
  });
}
