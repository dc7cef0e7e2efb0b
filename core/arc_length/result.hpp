// SPDX-License-Identifier: MIT
// The result of a method for arc length.
#pragma once

#include <cstdint>
#include <limits>

namespace bezierbench {

/// A length with its method's estimate of the error.
struct ArcLength {
  double length = 0;
  double error_estimate = std::numeric_limits<double>::quiet_NaN();  ///< absolute; NaN: the method has none
  std::int64_t evaluations = 0;                                      ///< of the speed or, for chords, of the curve
  bool converged = false;  ///< the estimate is at most tolerance times the length: the promise
};

}  // namespace bezierbench
