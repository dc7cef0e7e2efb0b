// SPDX-License-Identifier: MIT
// Studies of kind `derivative`: derivatives of random curves at random t, of each order, against the exact ones.
#pragma once

#include <memory>

#include "experiments/race/timed_problem.hpp"
#include "experiments/run/job.hpp"

namespace bezierbench::studies {

/// The job of the study. Throws Failure(usage) for inputs that the kind does not take, and where no method takes curves
/// of this form.
std::unique_ptr<run::Job> derivative_job(const suite::Study& study, const run::JobContext& context);

extern const race::TimedProblem timed_derivative;

}  // namespace bezierbench::studies
