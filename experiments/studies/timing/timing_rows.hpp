// SPDX-License-Identifier: MIT
// timing.csv: the times of a study's races, a row per method, and a row per mode for the sentinel.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "experiments/race/race.hpp"
#include "experiments/run/job.hpp"

namespace bezierbench::studies {

/// Races without repetitions have no rows. Times are medians over repetitions, also in units of the sentinel of the
/// same repetition (`sentinel_units`), with their intervals; so are ratios, each the median over the rounds of a
/// repetition. Of evaluators `limit_ns` is the least time that this processor could take, and `share_of_limit` the part
/// that it is of the time without that of an empty kernel, `call_ns`. `quality` is `unchecked` where a timed result was
/// not the judged one, `few_rounds` where there are too few repetitions for an interval, else `ok`. `sentinel_ns` and
/// `sweep_ns` are the times of the two sentinels. The sentinel's row is over all races of its mode, so it has no
/// dimension or degree.
void write_timing_rows(const suite::Study& study, const std::vector<race::Race>& races, tables::Tables& tables);

/// The row of the method at place `method` of a race that ran. Its ratio is to the method at place `base`.
void add_timing_row(tables::Tables& tables, const suite::Study& study, const race::Race& race, std::size_t method,
                    std::optional<std::size_t> base);

// cost.csv: what the processor does for a point, as Callgrind counts it; a row per method of every race that was counted.

void write_cost_rows(const suite::Study& study, const std::vector<race::Race>& races, tables::Tables& tables);

/// The row of the method at place `method` of a race that was counted.
void add_cost_row(tables::Tables& tables, const suite::Study& study, const race::Race& race, std::size_t method);

// complexity.csv: the growth of a study's times with the degree or the number of points, against the claims of its
// methods.

/// One row per method, scalar type, dimension and mode that ran at three different sizes or more: the exponent is that
/// of the degree or, where first_points and last_points are not empty, of the number of points. `claimed` is the
/// method's cost_exponent; in mode one_shot, where a curve is prepared for every point, the larger of that and its
/// prepare_exponent. A problem whose methods claim no exponent has no rows.
void write_complexity_rows(const suite::Study& study, const std::vector<race::Race>& races, race::Size size,
                           tables::Tables& tables);

}  // namespace bezierbench::studies
