// SPDX-License-Identifier: MIT
// One repetition of a race among rivals that were judged beforehand.
#pragma once

#include <cstddef>

#include "experiments/race/race_cell.hpp"
#include "experiments/race/timed_problem.hpp"

namespace bezierbench::race {

/// Races all rivals and the sentinels against each other. A rival whose results were wrong is not `checked`.
RaceCellLaps race_of(const RaceCell& race_cell, const suite::Study& study, JudgedRivals judged, std::size_t repetition,
                     const RaceOptions& options);

}  // namespace bezierbench::race
