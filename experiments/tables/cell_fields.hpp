// SPDX-License-Identifier: MIT
// The columns and fields of a row that identify its cell, and fields of statistics and counts.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "experiments/metric/counts.hpp"
#include "experiments/sample/cell.hpp"
#include "experiments/suite/suite.hpp"
#include "experiments/tables/tables.hpp"

namespace bezierbench::tables {

/// study,form,method,scalar,dimension,degree,coordinate_range,t_min,t_max,generator,curves
const std::vector<std::string>& cell_columns();

/// The fields of cell_columns().
std::vector<Field> cell_fields(const suite::Study& study, const sample::Cell& cell, std::string_view method,
                               suite::ScalarKind scalar);

/// coordinate_range,t_min,t_max,generator,curves: how the inputs of a cell were drawn, or which curve set they are
/// from; then the generator is the placement of its curves. These are the last of cell_columns().
const std::vector<std::string>& drawn_columns();

/// The fields of drawn_columns().
std::vector<Field> drawn_fields(const sample::Cell& cell);

/// The fields of cell_columns() without the method, as text for a message.
std::string describe(const suite::Study& study, const sample::Cell& cell, suite::ScalarKind scalar);

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
