// SPDX-License-Identifier: MIT
// roofline.csv: the batch kernels' share of the peak of each target, which goals they reach, and how near all kernels
// are to the limit of the processor.
#pragma once

#include <vector>

#include "experiments/run/job.hpp"
#include "experiments/studies/roofline/roofline_race.hpp"

namespace bezierbench::studies {

/// A row per method, target, mode, scalar type and cell; races that did not run have none. Target `scalar` is the kernel
/// for one point, in the modes `point` and `latency`, and has no peak. Shares are taken within rounds, where method and
/// peak met the same conditions. `goal_share` and `goal_ns` are the goals of the row, if it has any, and `goal_met` is
/// `yes` or `no`. `quality` is `noisy` where the peak of a race was more than 2 % slower than in the quickest of the
/// study: other processes disturbed the race.
void write_roofline_rows(const suite::Study& study, const std::vector<RooflineRace>& races, tables::Tables& tables);

/// The keys of the same rows, of races before they run, on this processor.
void list_roofline_rows(const suite::Study& study, const std::vector<RooflineRace>& races, tables::Tables& tables);

}  // namespace bezierbench::studies
