// SPDX-License-Identifier: MIT
// Studies of kind `arc_length`: lengths of random curves over each interval of t, to each tolerance, against the true
// lengths. A method that reports that it kept its tolerance and did not fails the run. Rows of methods that are not
// bit-stable go to arc_length_unstable.csv.
#pragma once

#include <memory>

#include "experiments/race/timed_problem.hpp"
#include "experiments/run/job.hpp"

namespace bezierbench::studies {

/// The job of the study. Throws Failure(usage) for inputs that the kind does not take.
std::unique_ptr<run::Job> arc_length_job(const suite::Study& study, const run::JobContext& context);

extern const race::TimedProblem timed_arc_length;

}  // namespace bezierbench::studies
