// SPDX-License-Identifier: MIT
// The bound of one point of a grid, for TrialScale.
#pragma once

#include <cmath>

#include "core/basis/grid_bound.hpp"
#include "experiments/metric/trial_scale.hpp"

namespace bezierbench::metric {

/// The bound of point k of `steps`, for a curve of this degree.
inline BoundAtDegree bound_at(const GridBound& bound, int degree, int k, int steps, const Arithmetic& arithmetic) {
  const ErrorBound of_no_point{.text = bound.text,
                               .amplification = bound.amplification,
                               .factor = [](int, double) { return 0.0; },
                               .underflow = [](int) { return 0.0; },
                               .underflow_scales_with_coefficients = bound.underflow_scales_with_coefficients};
  BoundAtDegree at(of_no_point, degree, arithmetic);
  at.factor = bound.factor(degree, k, arithmetic.unit_roundoff);
  at.underflow = std::ceil(bound.underflow(degree, steps));
  at.growth = bound.growth(degree, steps);
  return at;
}

}  // namespace bezierbench::metric
