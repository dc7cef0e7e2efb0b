// SPDX-License-Identifier: MIT
// Arc lengths by a method, true ones, and errors; parameters at a length.
#include <algorithm>
#include <cmath>

#include "bindings/c/curve.hpp"
#include "core/arc_length/inverse/kernel.hpp"
#include "core/arc_length/kernel.hpp"
#include "reference/companion/exact_roots.hpp"
#include "reference/length/true_length.hpp"

using namespace bezierbench;

namespace {

/// Throws Refused unless these are parameters of a part of the curve, NaN is not, and the part has no pole.
void require_part(const CurveView<double>& curve, double from, double to) {
  c::require(0 <= from && from <= to && to <= 1, BB_ERROR_PARAMETER);
  c::require(!reference::pole(curve, from, to), BB_ERROR_NO_POINT);
}

/// The curve in one of the forms that have lengths.
CurveView<double> curve_with_length(const bb_curve* curve) {
  const auto view = c::curve_of(curve);
  c::require(view.form != Form::power, BB_ERROR_FORM);
  return view;
}

void require_tolerance(double tolerance) { c::require(std::isfinite(tolerance) && tolerance > 0, BB_ERROR_TOLERANCE); }

}  // namespace

int bb_arc_length(const char* method, const bb_curve* curve, double from, double to, double tolerance,
                  bb_length* length) {
  return c::guarded([&] {
    const auto view = c::curve_of(curve);
    const auto& kernel = c::chosen(arc_length_kernels(view.dimension), method, view);
    require_part(view, from, to);
    require_tolerance(tolerance);
    c::require_pointers(length);
    const auto found = kernel.measure(view, from, to, tolerance);
    *length = {found.length, found.error_estimate, found.evaluations, found.converged ? 1 : 0};
  });
}

int bb_exact_arc_length(const bb_curve* curve, double from, double to, double* length) {
  return c::guarded([&] {
    const auto view = curve_with_length(curve);
    require_part(view, from, to);
    c::require_pointers(length);
    *length = reference::TrueLength(view, from, to).value().convert_to<double>();
  });
}

int bb_arc_length_error(const bb_curve* curve, double from, double to, double length, double* error) {
  return c::guarded([&] {
    const auto view = curve_with_length(curve);
    require_part(view, from, to);
    c::require_pointers(error);
    *error = reference::TrueLength(view, from, to).error_of(length);
  });
}

int bb_at_length(const char* method, const bb_curve* curve, double length, double tolerance, bb_parameter* found) {
  return c::guarded([&] {
    const auto view = c::curve_of(curve);
    const auto& kernel = c::chosen(inverse_arc_length_kernels(view.dimension), method, view);
    require_tolerance(tolerance);
    c::require(!reference::pole(view), BB_ERROR_NO_POINT);
    const double whole = whole_length(view);
    c::require(0 <= length && length <= whole + tolerance * whole, BB_ERROR_PARAMETER);
    c::require_pointers(found);
    const auto result = kernel.solve(view, std::min(length, whole), tolerance);
    *found = {result.t, result.error_estimate, result.iterations, result.converged ? 1 : 0};
  });
}
