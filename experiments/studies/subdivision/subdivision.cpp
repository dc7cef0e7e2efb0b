// SPDX-License-Identifier: MIT
#include "experiments/studies/subdivision/subdivision.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "experiments/failure.hpp"
#include "experiments/race/timed_companion.hpp"
#include "experiments/studies/subdivision/problem.hpp"
#include "experiments/studies/trial/trial_study.hpp"

namespace bezierbench::studies {

void check_subdivision(const suite::Study& study) {
  if (study.curve == suite::CurveKind::polynomial)
    throw Failure(
        Exit::usage,
        fmt::format("study \"{}\": what is split has control points; write curve = \"bezier\" or \"rational\"",
                    study.id));
  if (std::ranges::any_of(study.scalar, [](auto scalar) { return scalar != suite::ScalarKind::float64; }))
    throw Failure(Exit::usage,
                  fmt::format("study \"{}\": curves are split in double only; leave scalar out", study.id));
}

std::unique_ptr<run::Job> subdivision_job(const suite::Study& study, const run::JobContext& context) {
  return trial_job<SubdivisionProblem>(study, context);
}

constexpr race::TimedProblem timed_subdivision = race::timed_companion<SubdivisionProblem>();

}  // namespace bezierbench::studies
