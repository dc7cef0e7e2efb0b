// SPDX-License-Identifier: MIT
#include "experiments/metric/error_units.hpp"

#include "experiments/metric/tally.hpp"
#include "reference/error/trial_scale.hpp"

namespace bezierbench::metric {

ErrorLanes in_units(const ErrorLanes& errors, const ErrorLanes& divisors, double unit) {
  ErrorLanes units;
  for (std::size_t k = 0; k < units.size(); ++k)
    units[k] = to_24_bits(reference::in_units(errors[k], divisors[k], unit));
  return units;
}

}  // namespace bezierbench::metric
