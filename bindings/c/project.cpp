// SPDX-License-Identifier: MIT
// Projections by a method, true ones, and errors.
#include "bindings/c/curve.hpp"
#include "core/project/kernel.hpp"
#include "reference/companion/exact_roots.hpp"
#include "reference/companion/projection.hpp"

using namespace bezierbench;

namespace {

std::span<const double> point_of(const CurveView<double>& curve, const double* point) {
  return c::finite_values(point, static_cast<std::size_t>(curve.dimension));
}

/// Throws Refused for a rational curve with a pole.
void require_no_pole(const CurveView<double>& curve) { c::require(!reference::pole(curve), BB_ERROR_NO_POINT); }

reference::ExactProjection exact_projection(const bb_curve* curve, const double* point) {
  const auto view = c::curve_of(curve);
  c::require(view.form != Form::power, BB_ERROR_FORM);
  c::require(view.degree >= 1, BB_ERROR_DEGREE);
  require_no_pole(view);
  return reference::projection(view, point_of(view, point));
}

}  // namespace

int bb_project(const char* method, const bb_curve* curve, const double* point, bb_foot* foot) {
  return c::guarded([&] {
    const auto view = c::curve_of(curve);
    const auto& kernel = c::chosen(projection_kernels(view.dimension), method, view);
    const auto at = point_of(view, point);
    require_no_pole(view);
    c::require_pointers(foot);
    const auto found = kernel.project(view, at);
    *foot = {found.t, found.distance, found.candidates, found.converged ? 1 : 0};
  });
}

int bb_exact_project(const bb_curve* curve, const double* point, double* t, double* distance) {
  return c::guarded([&] {
    c::require_pointers(t, distance);
    const auto exact = exact_projection(curve, point);
    *t = reference::round_to(reference::binary64, exact.foot().t);
    *distance = reference::square_root(reference::binary64, exact.foot().distance_squared);
  });
}

int bb_project_error(const bb_curve* curve, const double* point, double t, double distance, double* error) {
  return c::guarded([&] {
    c::require_pointers(error);
    *error = reference::foot_error(reference::binary64, t, distance, exact_projection(curve, point));
  });
}
