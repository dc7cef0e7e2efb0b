// SPDX-License-Identifier: MIT
// Errors in the units in which they are judged and kept.
#pragma once

#include "experiments/metric/tally.hpp"
#include "reference/certified_points.hpp"

namespace bezierbench::metric {

/// error / divisor / unit; 0 for error 0, whatever the divisor. An error over a divisor of 0 is infinite.
inline double in_units(double error, double divisor, double unit = 1) {
  const double quotient = error / divisor / unit;
  return error == 0 ? 0 : quotient;
}

using ErrorLanes = reference::CertifiedLanes;

/// in_units() of every trial of a group, rounded to 24 bits.
inline ErrorLanes in_units(const ErrorLanes& errors, const ErrorLanes& divisors, double unit = 1) {
  ErrorLanes units;
  for (std::size_t k = 0; k < units.size(); ++k) units[k] = to_24_bits(in_units(errors[k], divisors[k], unit));
  return units;
}

}  // namespace bezierbench::metric
