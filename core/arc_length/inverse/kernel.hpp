// SPDX-License-Identifier: MIT
// The methods for inverse arc length behind function pointers.
#pragma once

#include <cstdint>
#include <limits>
#include <span>

#include "core/curve_view.hpp"
#include "core/method.hpp"

namespace bezierbench {

/// A parameter, with the method's estimate of its error.
struct InverseArcLength {
  double t = std::numeric_limits<double>::quiet_NaN();
  double error_estimate = std::numeric_limits<double>::quiet_NaN();  ///< absolute error of the length up to t
  std::int64_t iterations = 0;                                       ///< parameters, or sets of them, tried
  std::int64_t evaluations = 0;  ///< evaluations of the speed and its derivative or, for chords, of the curve
  bool converged = false;        ///< error_estimate is at most tolerance times the length of the whole curve
};

/// One method, for Bezier curves of one dimension.
struct InverseArcLengthKernel {
  const MethodInfo* info;
  int dimension;
  /// The parameter at which the length of `curve` from its beginning is `target`, up to `tolerance` > 0 times the
  /// length of the curve. Sizes are scaled by a power of two first, so that results do not depend on the size of the
  /// coordinates. For a curve that is a point the result is 0, converged if `target` is 0.
  InverseArcLength (*solve)(const CurveView<double>& curve, double target, double tolerance);
};

/// All methods, in roster order. Dimension is 1, 2 or 3.
std::span<const InverseArcLengthKernel> inverse_arc_length_kernels(int dimension);

}  // namespace bezierbench
