// SPDX-License-Identifier: MIT
// Fields of statistics and counts.
#pragma once

#include "experiments/metric/counts.hpp"
#include "experiments/tables/field.hpp"

namespace bezierbench::tables {

using Statistic = double (*)(const metric::Tally&);
inline constexpr Statistic mean = [](const metric::Tally& tally) { return tally.mean(); };
inline constexpr Statistic root_mean_square = [](const metric::Tally& tally) { return tally.root_mean_square(); };
inline constexpr Statistic median = [](const metric::Tally& tally) { return tally.quantile(0.5); };
inline constexpr Statistic p99 = [](const metric::Tally& tally) { return tally.quantile(0.99); };
inline constexpr Statistic largest = [](const metric::Tally& tally) { return tally.max(); };

/// The statistic as a field; empty where no trial was tallied.
inline Field field(const metric::Tally& tally, Statistic which) {
  return tally.count() > 0 ? Field(which(tally)) : Field();
}

inline Field field(const metric::TrialCount& trials) { return field(trials.count); }
inline Field field(const metric::Largest<double>& most) { return most.value; }

}  // namespace bezierbench::tables
