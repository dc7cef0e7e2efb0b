// SPDX-License-Identifier: MIT
// Studies of kind `arc_length`: lengths of random curves between the ends of each interval of t, tolerance by
// tolerance, against the true ones. A method that says that it kept its tolerance and did not fails the run. Methods
// that are not bit-stable have a file of their own, arc_length_unstable.csv.
#pragma once

#include <memory>

#include "experiments/race/timed_problem.hpp"
#include "experiments/run/job.hpp"

namespace bezierbench::studies {

/// Throws Failure(usage) for inputs that the kind does not take.
std::unique_ptr<run::Job> arc_length_job(const suite::Study& study, const run::JobContext& context);

extern const race::TimedProblem timed_arc_length;

}  // namespace bezierbench::studies
