// SPDX-License-Identifier: MIT
#include "experiments/race/repetition.hpp"

#include "experiments/metric/order_statistics.hpp"

namespace bezierbench::race {

RaceOptions options_of_a_repetition() {
  RaceOptions options;
  options.rounds /= repetitions_per_race;
  options.least_rounds = (options.least_rounds + repetitions_per_race - 1) / repetitions_per_race;
  options.rival_seconds /= repetitions_per_race;
  options.most_seconds /= repetitions_per_race;
  return options;
}

double median_ns(const Lap& repetition) { return metric::median(repetition.ns_per_point); }

double median_ratio(const Lap& repetition, const Lap& base) {
  std::vector<double> ratios;
  for (std::size_t round = 0; round < repetition.ns_per_point.size(); ++round)
    ratios.push_back(repetition.ns_per_point[round] / base.ns_per_point[round]);
  return metric::median(ratios);
}

std::vector<double> repetition_ratios(std::span<const Lap> repetitions, std::span<const Lap> base) {
  std::vector<double> ratios;
  for (std::size_t k = 0; k < repetitions.size(); ++k) ratios.push_back(median_ratio(repetitions[k], base[k]));
  return ratios;
}

}  // namespace bezierbench::race
