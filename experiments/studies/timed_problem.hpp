// SPDX-License-Identifier: MIT
// What a timing study can ask: evaluation, or a companion problem, whose methods it then names in place of evaluators.
// Each is one header (timed_<problem>.hpp) and one line in timed_problem.cpp.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "core/method.hpp"
#include "experiments/studies/heat.hpp"
#include "experiments/suite/suite.hpp"
#include "experiments/timing/race.hpp"

namespace bezierbench::studies {

/// Contestants, and whether the results that each must reproduce are right.
struct JudgedRivals {
  std::vector<timing::Rival> rivals;
  std::vector<bool> right;
  std::shared_ptr<const void> inputs;  ///< what the rivals read
};

/// What the costs that the methods of a problem claim grow with.
enum class Size { unclaimed, degree, points };

struct TimedProblem {
  Problem problem;
  Size size;
  /// The heats of a study, none of which ran. Throws Failure(usage) for what cannot be timed.
  std::vector<Heat> (*heats)(const suite::Study& study);
  /// One rival for each method of the heat.
  JudgedRivals (*rivals)(const Heat& heat, const suite::Study& study, std::uint64_t seed);
};

/// The companion problem whose methods the study names, else evaluation; a glob that takes in evaluators means those.
/// Throws Failure(usage) for one that is not timed.
const TimedProblem& timed_problem(const suite::Study& study);

}  // namespace bezierbench::studies
