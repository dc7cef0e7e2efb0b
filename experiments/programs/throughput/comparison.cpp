// SPDX-License-Identifier: MIT
#include "experiments/programs/throughput/comparison.hpp"

#include "experiments/metric/order_statistics.hpp"

namespace bezierbench::throughput {

Comparison compare(const race::Rival& what, const race::Lap& lap, const race::Rival& than, const race::Lap& other) {
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
