// SPDX-License-Identifier: MIT
#include "experiments/timing/sitting.hpp"

#include "experiments/metric/order_statistics.hpp"

namespace bezierbench::timing {

RaceOptions options_of_a_sitting() {
  RaceOptions options;
  options.rounds /= sittings_per_race;
  options.least_rounds = (options.least_rounds + sittings_per_race - 1) / sittings_per_race;
  options.rival_seconds /= sittings_per_race;
  options.most_seconds /= sittings_per_race;
  return options;
}

double median_ns(const Lap& sitting) { return metric::median(sitting.ns_per_point); }

double median_ratio(const Lap& sitting, const Lap& base) {
  std::vector<double> ratios;
  for (std::size_t round = 0; round < sitting.ns_per_point.size(); ++round)
    ratios.push_back(sitting.ns_per_point[round] / base.ns_per_point[round]);
  return metric::median(ratios);
}

std::vector<double> sitting_ratios(std::span<const Lap> sittings, std::span<const Lap> base) {
  std::vector<double> ratios;
  for (std::size_t k = 0; k < sittings.size(); ++k) ratios.push_back(median_ratio(sittings[k], base[k]));
  return ratios;
}

}  // namespace bezierbench::timing
