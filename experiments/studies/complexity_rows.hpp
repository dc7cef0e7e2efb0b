// SPDX-License-Identifier: MIT
// complexity.csv: how the times of a study grow with the degree, against what its methods claim.
#pragma once

#include <vector>

#include "experiments/studies/heat.hpp"
#include "experiments/studies/job.hpp"

namespace bezierbench::studies {

/// One row per method, scalar type, dimension and mode that ran at three different degrees or more. `claimed` is the
/// method's cost_exponent; in mode one_shot, where a curve is prepared for every point, the larger of that and its
/// prepare_exponent.
void write_complexity_rows(const suite::Study& study, const std::vector<Heat>& heats, Tables& tables);

}  // namespace bezierbench::studies
