// SPDX-License-Identifier: MIT
// The result of a method for arc length.
#pragma once

#include <cstdint>
#include <limits>

namespace bezierbench {

/// A length, with the method's estimate of its error.
struct ArcLength {
  double length = 0;
  double error_estimate = std::numeric_limits<double>::quiet_NaN();  ///< absolute; NaN if the method has none
  std::int64_t evaluations = 0;                                      ///< of the speed or, for chords, the curve
  bool converged = false;  ///< error_estimate is at most tolerance times the length
};

}  // namespace bezierbench
