// SPDX-License-Identifier: MIT
#include "experiments/studies/interpolation/interpolation.hpp"

#include "experiments/judge/companions.hpp"
#include "experiments/race/timed_companion.hpp"
#include "experiments/studies/interpolation/problem.hpp"
#include "experiments/studies/trial/trial_study.hpp"

namespace bezierbench::studies {

std::unique_ptr<run::Job> interpolation_job(const suite::Study& study, const run::JobContext& context) {
  return trial_job<InterpolationProblem>(study, context);
}

constexpr race::TimedProblem timed_interpolation = race::timed_companion<InterpolationProblem>(race::Size::points);

}  // namespace bezierbench::studies
