// SPDX-License-Identifier: MIT
#include "experiments/metric/error_lanes.hpp"

#include "experiments/metric/tally.hpp"

namespace bezierbench::metric {

ErrorLanes in_units(const ErrorLanes& errors, const ErrorLanes& divisors, double unit) {
  ErrorLanes units;
  for (std::size_t k = 0; k < units.size(); ++k) {
    const double quotient = errors[k] / divisors[k] / unit;
    units[k] = to_24_bits(errors[k] == 0 ? 0 : quotient);
  }
  return units;
}

}  // namespace bezierbench::metric
