// SPDX-License-Identifier: MIT
// complexity.csv: the growth of a study's times with the degree or the number of points, against the claims of its
// methods.
#pragma once

#include <vector>

#include "experiments/race/race_cell.hpp"
#include "experiments/race/timed_problem.hpp"
#include "experiments/run/job.hpp"

namespace bezierbench::studies {

/// One row per method, scalar type, dimension and mode that ran at three different sizes or more: the exponent is that
/// of the degree or, where first_points and last_points are not empty, of the number of points. `claimed` is the
/// method's cost_exponent; in mode one_shot, where a curve is prepared for every point, the larger of that and its
/// prepare_exponent. A problem whose methods claim no exponent has no rows.
void write_complexity_rows(const suite::Study& study, const std::vector<race::RaceCell>& race_cells, race::Size size,
                           tables::Tables& tables);

}  // namespace bezierbench::studies
