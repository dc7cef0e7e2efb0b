// SPDX-License-Identifier: MIT
// The roots of a coordinate, of its derivative or of the curvature.
#include <cmath>
#include <cstdint>

#include "bindings/c/curve.hpp"
#include "reference/companion/exact_roots.hpp"

using namespace bezierbench;

namespace {

reference::Roots roots_of(const CurveView<double>& curve, int of, int axis, double value) {
  c::require(of == BB_ROOTS_OF_VALUE || of == BB_ROOTS_OF_DERIVATIVE || of == BB_ROOTS_OF_CURVATURE,
             BB_ERROR_PARAMETER);
  if (of == BB_ROOTS_OF_CURVATURE) {
    c::require(curve.dimension == 2, BB_ERROR_DIMENSION);
    return reference::roots_of_curvature(curve);
  }
  c::require(axis >= 0 && axis < curve.dimension, BB_ERROR_DIMENSION);
  if (of == BB_ROOTS_OF_DERIVATIVE) return reference::roots_of_derivative(curve, axis);
  c::require(std::isfinite(value), BB_ERROR_NOT_FINITE);
  return reference::roots_of_value(curve, axis, value);
}

}  // namespace

int bb_roots(const bb_curve* curve, int of, int axis, double value, double* t, int* multiplicities,
             std::size_t capacity, std::size_t* count) {
  return c::guarded([&] {
    const auto view = c::curve_of(curve);
    c::require_pointers(count);
    c::require(!reference::pole(view), BB_ERROR_NO_POINT);
    const auto [everywhere, roots] = roots_of(view, of, axis, value);
    *count = everywhere ? SIZE_MAX : roots.size();
    if (*count > capacity) return;
    if (roots.empty()) return;
    c::require_pointers(t, multiplicities);
    for (std::size_t k = 0; k < roots.size(); ++k) {
      t[k] = roots[k].t;
      multiplicities[k] = roots[k].multiplicity;
    }
  });
}
