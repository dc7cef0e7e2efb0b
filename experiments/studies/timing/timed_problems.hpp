// SPDX-License-Identifier: MIT
// The roster of timed problems.
#pragma once

#include "experiments/race/timed_problem.hpp"
#include "experiments/suite/suite.hpp"

namespace bezierbench::studies {

/// The companion problem whose methods the study names, else evaluation; a glob that matches evaluators means
/// evaluation. Throws Failure(usage) for a problem that cannot be timed.
const race::TimedProblem& timed_problem(const suite::Study& study);

}  // namespace bezierbench::studies
