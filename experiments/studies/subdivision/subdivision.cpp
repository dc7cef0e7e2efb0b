// SPDX-License-Identifier: MIT
#include "experiments/studies/subdivision/subdivision.hpp"

#include "experiments/race/timed_companion.hpp"
#include "experiments/studies/subdivision/problem.hpp"
#include "experiments/studies/trial/trial_study.hpp"

namespace bezierbench::studies {

std::unique_ptr<run::Job> subdivision_job(const suite::Study& study, const run::JobContext& context) {
  return trial_job<SubdivisionProblem>(study, context);
}

constexpr race::TimedProblem timed_subdivision = race::timed_companion<SubdivisionProblem>();

}  // namespace bezierbench::studies
