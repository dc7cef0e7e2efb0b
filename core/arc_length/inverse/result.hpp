// SPDX-License-Identifier: MIT
// The result of a method for inverse arc length.
#pragma once

#include <cstdint>
#include <limits>

namespace bezierbench {

/// A parameter, with the method's estimate of its error.
struct InverseArcLength {
  double t = std::numeric_limits<double>::quiet_NaN();
  double error_estimate = std::numeric_limits<double>::quiet_NaN();  ///< absolute error of the length up to t
  std::int64_t iterations = 0;                                       ///< parameters, or sets of them, tried
  std::int64_t evaluations = 0;  ///< evaluations of the speed and its derivative or, for chords, of the curve
  bool converged = false;        ///< error_estimate is at most tolerance times the length of the whole curve
};

}  // namespace bezierbench
