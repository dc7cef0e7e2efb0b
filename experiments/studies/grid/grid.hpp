// SPDX-License-Identifier: MIT
// Studies of kind `grid`: random curves at all k/m, k = 0..m; every point is judged against the exact one.
#pragma once

#include <memory>

#include "experiments/race/timed_problem.hpp"
#include "experiments/run/job.hpp"

namespace bezierbench::studies {

/// The job of the study. Throws Failure(usage) for inputs that the kind does not take, and where no method takes curves
/// of this form.
std::unique_ptr<run::Job> grid_job(const suite::Study& study, const run::JobContext& context);

extern const race::TimedProblem timed_grid;

}  // namespace bezierbench::studies
