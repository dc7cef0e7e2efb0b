// SPDX-License-Identifier: MIT
// Studies of kind `inverse_arc_length`: the parameter at a share of the length of random curves, to each tolerance,
// against the true parameter. The share is the trial's t, drawn from the interval of t. A method that reports that it
// kept its tolerance and did not fails the run. Writes inverse_arc_length.csv, and for each study spacing.csv: the
// curve of its first trial with points at equal steps of t and at equal steps of the length.
#pragma once

#include <memory>

#include "experiments/race/timed_problem.hpp"
#include "experiments/run/job.hpp"

namespace bezierbench::studies {

/// The job of the study. Throws Failure(usage) for inputs that the kind does not take.
std::unique_ptr<run::Job> inverse_arc_length_job(const suite::Study& study, const run::JobContext& context);

extern const race::TimedProblem timed_inverse_arc_length;

}  // namespace bezierbench::studies
