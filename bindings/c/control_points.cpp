// SPDX-License-Identifier: MIT
// The control points of a part of a curve, and of a curve in a higher degree.
#include <algorithm>
#include <cmath>

#include "bindings/c/more_axes.hpp"
#include "reference/companion/exact_control_points.hpp"

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

}  // namespace

int bb_part(const bb_curve* curve, double from, double to, const bb_half* part) {
  return c::guarded([&] {
    if (c::has_more_axes(curve)) {
      c::require_pointers(part);
      return c::by_axes(*curve, static_cast<std::size_t>(curve->degree) + 1, part->points,
                        [&](const bb_curve& some, double* of_some) {
                          const bb_half its_part{of_some, part->weights};
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
      c::require_pointers(elevated);
      c::require(degree >= curve->degree && degree <= max_degree, BB_ERROR_DEGREE);
      return c::by_axes(*curve, static_cast<std::size_t>(degree) + 1, elevated->points,
                        [&](const bb_curve& some, double* of_some) {
                          const bb_half its_points{of_some, elevated->weights};
                          return bb_elevate(&some, degree, &its_points);
                        });
    }
    const auto view = with_control_points(curve);
    c::require(degree >= view.degree && degree <= max_degree, BB_ERROR_DEGREE);
    require_place(elevated, view);
    write(reference::elevated_control_points(view, degree), elevated);
  });
}
