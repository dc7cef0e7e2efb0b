// SPDX-License-Identifier: MIT
#include "experiments/studies/interpolation/interpolation.hpp"

#include <fmt/format.h>

#include "experiments/failure.hpp"
#include "experiments/judge/companions.hpp"
#include "experiments/race/timed_companion.hpp"
#include "experiments/studies/interpolation/problem.hpp"
#include "experiments/studies/trial/trial_study.hpp"

namespace bezierbench::studies {

void check_interpolation(const suite::Study& study) {
  judge::check_bezier_in_double(study);
  judge::check_independent_points(study);
  if (study.t_interval != std::vector{suite::Interval{}})
    throw Failure(Exit::usage, fmt::format("study \"{}\": points are joined whole; leave t_interval out", study.id));
}

std::unique_ptr<run::Job> interpolation_job(const suite::Study& study, const run::JobContext& context) {
  return trial_job<InterpolationProblem>(study, context);
}

constexpr race::TimedProblem timed_interpolation = race::timed_companion<InterpolationProblem>(race::Size::points);

}  // namespace bezierbench::studies
