// SPDX-License-Identifier: MIT
// Studies of kind `fitting`: data of every kind in sample::data_kinds(), fitted to every tolerance and judged by their
// exact distance from the fitted curve. Writes fitting.csv, and to fitting_example.csv the first data set of each study
// in the plane with its fits.
#pragma once

#include <memory>

#include "experiments/race/timed_problem.hpp"
#include "experiments/run/job.hpp"

namespace bezierbench::studies {

/// The job of the study. Throws Failure(usage) for inputs that the kind does not take.
std::unique_ptr<run::Job> fitting_job(const suite::Study& study, const run::JobContext& context);

extern const race::TimedProblem timed_fitting;

}  // namespace bezierbench::studies
