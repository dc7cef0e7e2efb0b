// SPDX-License-Identifier: MIT
// Proved bounds of methods.
#include <algorithm>
#include <limits>
#include <vector>

#include "bindings/c/chosen.hpp"
#include "core/evaluate/kernel.hpp"
#include "experiments/metric/coordinate_error.hpp"
#include "reference/exact_curve.hpp"

using namespace bezierbench;

int bb_curve_bound(const char* method, const bb_curve* curve, const double* t, std::size_t count, bb_bound* bounds) {
  return c::guarded([&] {
    const auto view = c::curve_of(curve);
    const auto& info = *c::chosen(kernels<double>(view.dimension), method, view).info;
    const auto ts = c::parameters(info, t, count);
    c::require(info.bound.has_value(), BB_ERROR_NO_BOUND);
    if (ts.empty()) return;
    c::require_pointers(bounds);
    reference::ExactCurve exact;
    std::vector<bb_bound> result;
    for (const double at : ts) {
      const auto truth = exact.point(view, at);  // a copy: the next call changes the original
      c::require(truth.exists(), BB_ERROR_NO_POINT);
      const auto& p_tilde = exact.p_tilde(view, at);
      for (int axis = 0; axis < view.dimension; ++axis) {
        const double bound = metric::coordinate_bound(*info.bound, view, axis, at, truth.coordinate(axis));
        const auto units = metric::bound_units(bound, p_tilde.coordinate(axis));
        result.push_back({bound, units.value_or(std::numeric_limits<double>::infinity())});
      }
    }
    std::ranges::copy(result, bounds);
  });
}
