// SPDX-License-Identifier: MIT
// A curve as chords.
#include <algorithm>
#include <cmath>

#include "bindings/c/curve.hpp"
#include "core/flatten/kernel.hpp"
#include "reference/companion/exact_roots.hpp"

using namespace bezierbench;

int bb_flatten(const char* method, const bb_curve* curve, double tolerance, double* t, double* points,
               std::size_t capacity, std::size_t* ends, int* complete) {
  return c::guarded([&] {
    const auto view = c::curve_of(curve);
    const auto& kernel = c::chosen(flatten_kernels(view.dimension), method, view);
    c::require(!reference::pole(view), BB_ERROR_NO_POINT);
    c::require(std::isfinite(tolerance) && tolerance > 0, BB_ERROR_TOLERANCE);
    c::require_pointers(ends, complete);
    Flattening chords;
    kernel.flatten(view, tolerance, chords);
    const bool finite = std::ranges::all_of(chords.points, [](double x) { return std::isfinite(x); });
    c::require(finite, BB_ERROR_OVERFLOW);
    *ends = chords.t.size();
    *complete = chords.complete ? 1 : 0;
    if (chords.t.size() > capacity) return;
    c::require_pointers(t, points);
    std::ranges::copy(chords.t, t);
    std::ranges::copy(chords.points, points);
  });
}
