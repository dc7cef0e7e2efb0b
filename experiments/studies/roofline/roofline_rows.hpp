// SPDX-License-Identifier: MIT
// roofline.csv: how near the batch kernels come to what each target can do, and which goals they reach.
#pragma once

#include <vector>

#include "experiments/run/job.hpp"
#include "experiments/studies/roofline/roofline_race.hpp"

namespace bezierbench::studies {

/// A row per method, target, scalar type and cell; races that did not run have none. Target `scalar` is the scalar
/// kernel, one point at a time, and has no peak. Shares are taken round by round, in which method and peak met the same
/// machine. `goal_share` and `goal_ns` are what is asked of the row, where anything is, and `goal_met` is `yes` or
/// `no`. `quality` is `noisy` where the peak of a race was more than 2 % slower than in the quickest of the study:
/// others were at work.
void write_roofline_rows(const suite::Study& study, const std::vector<RooflineRace>& races, tables::Tables& tables);

}  // namespace bezierbench::studies
