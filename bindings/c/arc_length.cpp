// SPDX-License-Identifier: MIT
// Arc lengths by a method, true ones, and errors; parameters at a length.
#include <algorithm>
#include <cmath>

#include "bindings/c/chosen.hpp"
#include "core/arc_length/inverse/kernel.hpp"
#include "core/arc_length/kernel.hpp"
#include "reference/length/true_length.hpp"

using namespace bezierbench;

namespace {

/// Throws Refused unless these are parameters of a part of the curve; NaN is not.
void require_part(double from, double to) { c::require(0 <= from && from <= to && to <= 1, BB_ERROR_PARAMETER); }

void require_tolerance(double tolerance) { c::require(std::isfinite(tolerance) && tolerance > 0, BB_ERROR_TOLERANCE); }

}  // namespace

int bb_arc_length(const char* method, const bb_curve* curve, double from, double to, double tolerance,
                  bb_length* length) {
  return c::guarded([&] {
    const auto view = c::curve_of(curve);
    const auto& kernel = c::chosen(arc_length_kernels(view.dimension), method, view);
    require_part(from, to);
    require_tolerance(tolerance);
    c::require_pointers(length);
    const auto found = kernel.measure(view, from, to, tolerance);
    *length = {found.length, found.error_estimate, found.evaluations, found.converged ? 1 : 0};
  });
}

int bb_exact_arc_length(const bb_curve* curve, double from, double to, double* length) {
  return c::guarded([&] {
    const auto view = c::bernstein_curve_of(curve);
    require_part(from, to);
    c::require_pointers(length);
    *length = reference::TrueLength(view, from, to).value().convert_to<double>();
  });
}

int bb_arc_length_error(const bb_curve* curve, double from, double to, double length, double* error) {
  return c::guarded([&] {
    const auto view = c::bernstein_curve_of(curve);
    require_part(from, to);
    c::require_pointers(error);
    *error = reference::TrueLength(view, from, to).error_of(length);
  });
}

int bb_at_length(const char* method, const bb_curve* curve, double length, double tolerance, bb_parameter* found) {
  return c::guarded([&] {
    const auto view = c::curve_of(curve);
    const auto& kernel = c::chosen(inverse_arc_length_kernels(view.dimension), method, view);
    require_tolerance(tolerance);
    const double whole = whole_length(view);
    c::require(0 <= length && length <= whole + tolerance * whole, BB_ERROR_PARAMETER);
    c::require_pointers(found);
    const auto result = kernel.solve(view, std::min(length, whole), tolerance);
    *found = {result.t, result.error_estimate, result.iterations, result.converged ? 1 : 0};
  });
}
