// SPDX-License-Identifier: MIT
// What a timing study can ask: evaluation, or a companion problem, whose methods it then names in place of evaluators.
// Each is one line in studies/timing/timed_problems.cpp; a companion problem is timed as its problem.hpp states
// (race/timed_companion.hpp).
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "core/method.hpp"
#include "experiments/race/race.hpp"
#include "experiments/race/race_cell.hpp"
#include "experiments/suite/suite.hpp"

namespace bezierbench::race {

/// CompanionRivals, and whether the results that each must reproduce are right.
struct JudgedRivals {
  std::vector<Rival> rivals;
  std::vector<bool> right;
  std::shared_ptr<const void> inputs;  ///< what the rivals read
};

/// What the costs that the methods of a problem claim grow with.
enum class Size { unclaimed, degree, points };

struct TimedProblem {
  Problem problem;
  Size size;
  /// The race cells of a study, none of which ran. Throws Failure(usage) for what cannot be timed.
  std::vector<RaceCell> (*race_cells)(const suite::Study& study);
  /// One rival for each method of the race cell.
  JudgedRivals (*rivals)(const RaceCell& race_cell, const suite::Study& study, std::uint64_t seed);
};

}  // namespace bezierbench::race
