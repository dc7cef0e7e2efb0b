// SPDX-License-Identifier: MIT
// What bezierbench.mjs asks beyond the C interface: which methods are fused, and the truth about values in float of a curve in
// any form. A curve has doubles that are floats.
#include <algorithm>
#include <cmath>
#include <limits>
#include <string_view>
#include <vector>

#include "bindings/c/curve.hpp"
#include "core/bspline/kernel.hpp"
#include "core/derivative/kernel.hpp"
#include "core/fit/kernel.hpp"
#include "core/grid/kernel.hpp"
#include "reference/error/trial_scale.hpp"
#include "reference/exact_curve.hpp"

using namespace bezierbench;

namespace {

/// Hands the true point at every t, and p~ there, to `take`. Throws Refused where there is no point.
template <class Take>
void at_each(const CurveView<double>& curve, const double* t, std::size_t count, const Take& take) {
  reference::ExactCurve exact;
  for (const double at : c::finite_values(t, count)) {
    const auto truth = exact.point(curve, at);  // a copy: the next call changes the original
    c::require(truth.exists(), BB_ERROR_NO_POINT);
    take(at, truth, exact.p_tilde(curve, at));
  }
}

}  // namespace

// Problems that the module has no functions for are not on the list of methods, and their code is left out.
namespace bezierbench {
std::span<const BsplineKernel> bspline_kernels(int /*dimension*/) { return {}; }
std::span<const DerivativeKernel> derivative_kernels(int /*dimension*/) { return {}; }
std::span<const FittingKernel> fitting_kernels(int /*dimension*/) { return {}; }
std::span<const GridKernel> grid_kernels(int /*dimension*/) { return {}; }
}  // namespace bezierbench

extern "C" {

/// Whether an evaluator has fused multiply-adds, which are calls of a function in WebAssembly.
int bb_web_is_fused(const char* method) {
  for (const auto& kernel : kernels<double>(1))
    if (kernel.info->id == method) return kernel.info->fused ? 1 : 0;
  return 0;
}

/// bb_curve_exact, rounded to float.
int bb_web_exact_float(const bb_curve* curve, const double* t, std::size_t count, double* out) {
  return c::guarded([&] {
    const auto view = c::curve_of(curve);
    at_each(view, t, count, [&](double /*at*/, const auto& truth, const auto& /*p_tilde*/) {
      for (int axis = 0; axis < view.dimension; ++axis)
        *out++ = reference::round_to(reference::binary32, truth.coordinate(axis));
    });
  });
}

/// bb_curve_error with u and the spacing of float.
int bb_web_error_float(const bb_curve* curve, const double* t, std::size_t count, const double* values,
                       bb_error* errors) {
  return c::guarded([&] {
    const auto view = c::curve_of(curve);
    at_each(view, t, count, [&](double /*at*/, const auto& truth, const auto& p_tilde) {
      for (int axis = 0; axis < view.dimension; ++axis) {
        const auto exact = truth.coordinate(axis);
        const double value = *values++;
        auto judged = reference::coordinate_error(value, exact, p_tilde.coordinate(axis));
        judged.exact = reference::round_to(reference::binary32, exact);
        if (std::isfinite(value)) {
          constexpr long least = -149;
          const long spacing = exact.numerator == 0 ? least : std::max(reference::floor_log2(exact) - 23, least);
          const auto difference = reference::abs(reference::exactly(value) - exact);
          judged.error_ulp = reference::quotient(reference::binary64, difference, {1, 1, spacing});
          judged.error_u *= reference::double_arithmetic.unit_roundoff / reference::float_arithmetic.unit_roundoff;
        }
        *errors++ = {judged.exact, judged.error, judged.error_ulp, judged.error_u};
      }
    });
  });
}

/// bb_curve_bound for points in float.
int bb_web_bound_float(const char* method, const bb_curve* curve, const double* t, std::size_t count,
                       bb_bound* bounds) {
  return c::guarded([&] {
    const auto view = c::curve_of(curve);
    const std::vector<float> narrow(view.coefficients.begin(), view.coefficients.end());
    const CurveView<float> in_float{view.form, view.dimension, view.degree, narrow, {}};
    const auto& info = *c::evaluator(method, in_float).info;
    (void)c::parameters(info, t, count);
    c::require(info.bound.has_value(), BB_ERROR_NO_BOUND);
    const auto& arithmetic = reference::float_arithmetic;
    at_each(view, t, count, [&](double at, const auto& truth, const auto& p_tilde) {
      for (int axis = 0; axis < view.dimension; ++axis) {
        const double bound =
            reference::coordinate_bound(*info.bound, view, axis, at, truth.coordinate(axis), arithmetic);
        const auto units = reference::bound_units(bound, p_tilde.coordinate(axis), arithmetic);
        *bounds++ = {bound, units.value_or(std::numeric_limits<double>::infinity())};
      }
    });
  });
}

}  // extern "C"
