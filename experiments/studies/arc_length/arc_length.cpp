// SPDX-License-Identifier: MIT
#include "experiments/studies/arc_length/arc_length.hpp"

#include <cmath>

#include "experiments/race/timed_companion.hpp"
#include "experiments/studies/arc_length/problem.hpp"
#include "experiments/studies/trial/trial_study.hpp"

namespace bezierbench::studies {

void ArcLengthProblem::judge(const Kernel& /*method*/, const Drawn& drawn, double tolerance, const Answer& answer,
                             std::uint64_t number, Errors& errors) {
  const double length = drawn.truth->length();
  errors.promises.add(answer.converged, answer.evaluations);
  const double error = drawn.truth->error_of(answer.length, metric::to_24_bits);
  if (!std::isfinite(error)) {
    ++errors.promises.non_finite;
    return;
  }
  errors.error.add(error);
  errors.relative.add(error == 0 ? 0 : metric::to_24_bits(error / length));
  errors.promises.judge(answer.converged, error, tolerance * length, number);
}

bool ArcLengthProblem::is_right(const Kernel& /*method*/, const Drawn& drawn, double tolerance, const Answer& answer) {
  return Promises::keeps(drawn.truth->error_of(answer.length, metric::to_24_bits), tolerance * drawn.truth->length());
}

std::unique_ptr<run::Job> arc_length_job(const suite::Study& study, const run::JobContext& context) {
  return trial_job<ArcLengthProblem>(study, context);
}

constexpr race::TimedProblem timed_arc_length = race::timed_companion<ArcLengthProblem>();

}  // namespace bezierbench::studies
