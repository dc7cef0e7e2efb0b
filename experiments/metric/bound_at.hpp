// SPDX-License-Identifier: MIT
// Bounds of companion problems at one point of their answer.
#pragma once

#include <cmath>
#include <limits>

#include "core/bound/bspline_bound.hpp"
#include "core/bound/grid_bound.hpp"
#include "reference/error/trial_scale.hpp"

namespace bezierbench::metric {

/// The bound of point k of `steps`, for a curve of this degree.
inline reference::BoundAtDegree bound_at(const GridBound& bound, int degree, int k, int steps,
                                         const reference::Arithmetic& arithmetic) {
  const ErrorBound amplification_only{.text = bound.text,
                                      .amplification = bound.amplification,
                                      .factor = [](int, double) { return 0.0; },
                                      .underflow = [](int) { return 0.0; },
                                      .underflow_scales_with_coefficients = bound.underflow_scales_with_coefficients};
  reference::BoundAtDegree at(amplification_only, degree, arithmetic);
  at.factor = bound.factor(degree, k, arithmetic.unit_roundoff);
  at.underflow = std::ceil(bound.underflow(degree, steps));
  at.growth = bound.growth(degree, steps);
  return at;
}

// The bound of a point of a B-spline curve, or of a control point of a knot span in Bernstein form, in coordinate
// units.

/// The sizes in a bound: on one axis or, with Euclidean norms as magnitudes, on all axes at once (see TrialScale).
struct BsplineSizes {
  int degree;
  int axes;
  double p_tilde;
  double largest;  ///< max |d_i|
};

/// Infinite where a result on the way may overflow.
inline double bound_at(const BsplineBound::Part& bound, const BsplineSizes& sizes,
                       const reference::Arithmetic& arithmetic) {
  const double u = arithmetic.unit_roundoff;
  if (!stays_in_range(sizes.largest, sizes.degree, u)) return std::numeric_limits<double>::infinity();
  const double lost = std::ceil(bound.underflow(sizes.degree)) * sizes.axes * (1 + sizes.largest);
  return bound.factor(sizes.degree, u) * u * sizes.p_tilde + lost * arithmetic.smallest_subnormal;
}

}  // namespace bezierbench::metric
