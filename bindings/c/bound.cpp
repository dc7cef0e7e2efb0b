// SPDX-License-Identifier: MIT
// Proved bounds of methods.
#include <algorithm>
#include <limits>
#include <vector>

#include "bindings/c/chosen.hpp"
#include "core/evaluate/kernel/kernel.hpp"
#include "reference/error/trial_scale.hpp"
#include "reference/exact_curve.hpp"

using namespace bezierbench;

namespace {

/// The bounds at every t of a curve in double, whose values may be those of floats. Throws Refused where there are none.
template <class Scalar>
void write_bounds(const MethodInfo& info, const CurveView<double>& curve, std::span<const Scalar> ts,
                  const reference::Arithmetic& arithmetic, bb_bound* bounds) {
  c::require(info.bound.has_value(), BB_ERROR_NO_BOUND);
  if (ts.empty()) return;
  c::require_pointers(bounds);
  reference::ExactCurve exact;
  std::vector<bb_bound> result;
  for (const double at : ts) {
    const auto truth = exact.point(curve, at);  // a copy: the next call changes the original
    c::require(truth.exists(), BB_ERROR_NO_POINT);
    const auto& p_tilde = exact.p_tilde(curve, at);
    for (int axis = 0; axis < curve.dimension; ++axis) {
      const double bound =
          reference::coordinate_bound(*info.bound, curve, axis, at, truth.coordinate(axis), arithmetic);
      const auto units = reference::bound_units(bound, p_tilde.coordinate(axis), arithmetic);
      result.push_back({bound, units.value_or(std::numeric_limits<double>::infinity())});
    }
  }
  std::ranges::copy(result, bounds);
}

}  // namespace

int bb_curve_bound(const char* method, const bb_curve* curve, const double* t, std::size_t count, bb_bound* bounds) {
  return c::guarded([&] {
    const auto view = c::curve_of(curve);
    const auto& info = *c::evaluator(method, view).info;
    write_bounds(info, view, c::parameters(info, t, count), reference::double_arithmetic, bounds);
  });
}

int bb_bound_float(const char* method, int dimension, int degree, const float* points, const float* t,
                   std::size_t count, bb_bound* bounds) {
  return c::guarded([&] {
    const auto view = c::bezier_curve(dimension, degree, points);
    const auto& info = *c::evaluator(method, view).info;
    const std::vector<double> values(view.coefficients.begin(), view.coefficients.end());
    write_bounds(info, {Form::bernstein, dimension, degree, values}, c::parameters(info, t, count),
                 reference::float_arithmetic, bounds);
  });
}
