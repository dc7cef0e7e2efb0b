// SPDX-License-Identifier: MIT
// A problem that a timing study can time: evaluation, or a companion problem, whose methods the study then names in
// place of evaluators. Each is one header (studies/<kind>/timed_<problem>.hpp) and one line in
// studies/timing/timed_problems.cpp.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "core/method.hpp"
#include "experiments/race/race.hpp"
#include "experiments/race/race_cell.hpp"
#include "experiments/suite/suite.hpp"

namespace bezierbench::race {

/// Rivals, and whether the results that each must reproduce are right.
struct JudgedRivals {
  std::vector<Rival> rivals;
  std::vector<bool> right;
  std::shared_ptr<const void> inputs;  ///< the inputs that the rivals read
};

/// The size that the claimed costs of a problem's methods grow with.
enum class Size { unclaimed, degree, points };

struct TimedProblem {
  Problem problem;
  Size size;
  /// The race cells of a study, before any repetition. Throws Failure(usage) for studies that cannot be timed.
  std::vector<RaceCell> (*race_cells)(const suite::Study& study);
  /// One rival for each method of the race cell.
  JudgedRivals (*rivals)(const RaceCell& race_cell, const suite::Study& study, std::uint64_t seed);
};

}  // namespace bezierbench::race
