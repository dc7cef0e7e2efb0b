// SPDX-License-Identifier: MIT
// timing.csv: what the heats of a study gave, a row per method, and a row per mode for the sentinel.
#pragma once

#include <vector>

#include "experiments/studies/heat.hpp"
#include "experiments/studies/job.hpp"

namespace bezierbench::studies {

/// Heats that did not run have no rows. Times are medians over sittings, also in units of the sentinel of the same
/// sitting (`sentinel_units`), with their intervals; so are ratios, each the median over the rounds of a sitting.
/// `quality` is `noisy` where a sentinel drifted or the sittings disagree, else `ok`. `sentinel_ns` and `sweep_ns` are
/// what the two sentinels took beside. The sentinel's row is over all heats of its mode, so it has no dimension or
/// degree, and is `noisy` where it drifted in any of them.
void write_timing_rows(const suite::Study& study, const std::vector<Heat>& heats, Tables& tables);

}  // namespace bezierbench::studies
