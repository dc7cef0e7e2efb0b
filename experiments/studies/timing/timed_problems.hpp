// SPDX-License-Identifier: MIT
// The roster of what a timing study can ask.
#pragma once

#include "experiments/race/timed_problem.hpp"
#include "experiments/suite/suite.hpp"

namespace bezierbench::studies {

/// The companion problem whose methods the study names, else evaluation; a glob that takes in evaluators means those.
/// Throws Failure(usage) for one that is not timed.
const race::TimedProblem& timed_problem(const suite::Study& study);

}  // namespace bezierbench::studies
