// SPDX-License-Identifier: MIT
#include "experiments/cli/throughput_program/comparison.hpp"

#include "experiments/metric/order_statistics.hpp"

namespace bezierbench::throughput {

Comparison compare(const timing::Rival& what, const timing::Lap& lap, const timing::Rival& than,
                   const timing::Lap& other) {
  std::vector<double> ratios;
  for (std::size_t round = 0; round < lap.ns_per_point.size(); ++round)
    ratios.push_back(other.ns_per_point[round] / lap.ns_per_point[round]);
  return {.what = what.name,
          .than = than.name,
          .ns = metric::quantile(lap.ns_per_point, 0.5),
          .than_ns = metric::quantile(other.ns_per_point, 0.5),
          .ratio = metric::quantile(ratios, 0.5)};
}

}  // namespace bezierbench::throughput
