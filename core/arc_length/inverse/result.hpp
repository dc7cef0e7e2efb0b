// SPDX-License-Identifier: MIT
// The result of a method for inverse arc length.
#pragma once

#include <cstdint>
#include <limits>

namespace bezierbench {

/// A parameter with its method's estimate of the error.
struct InverseArcLength {
  double t = std::numeric_limits<double>::quiet_NaN();
  double error_estimate = std::numeric_limits<double>::quiet_NaN();  ///< of the length up to t, absolute
  std::int64_t iterations = 0;                                       ///< parameters, or sets of them, that were tried
  std::int64_t evaluations = 0;  ///< of the speed and its derivative or, for chords, of the curve
  bool converged = false;        ///< the estimate is at most tolerance times the length of the whole curve: the promise
};

}  // namespace bezierbench
