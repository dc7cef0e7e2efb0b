// SPDX-License-Identifier: MIT
// Fields of statistics and counts, with one spelling for every table.
#pragma once

#include <cstdint>
#include <string>

#include "experiments/metric/counts.hpp"
#include "experiments/number/number.hpp"

namespace bezierbench::tables {

using Statistic = double (*)(const metric::Tally&);
inline constexpr Statistic mean = [](const metric::Tally& tally) { return tally.mean(); };
inline constexpr Statistic root_mean_square = [](const metric::Tally& tally) { return tally.root_mean_square(); };
inline constexpr Statistic median = [](const metric::Tally& tally) { return tally.quantile(0.5); };
inline constexpr Statistic p99 = [](const metric::Tally& tally) { return tally.quantile(0.99); };
inline constexpr Statistic largest = [](const metric::Tally& tally) { return tally.max(); };

/// The statistic as a field; empty where no trial was tallied.
inline std::string field(const metric::Tally& tally, Statistic which) {
  return tally.count() > 0 ? number::decimal(which(tally)) : "";
}

inline std::string field(std::uint64_t count) { return std::to_string(count); }
inline std::string field(const metric::TrialCount& trials) { return std::to_string(trials.count); }
inline std::string field(const metric::Largest<double>& most) { return number::decimal(most.value); }

}  // namespace bezierbench::tables
