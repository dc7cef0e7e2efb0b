// SPDX-License-Identifier: MIT
#include "experiments/studies/inverse_arc_length/inverse_arc_length.hpp"

#include <cmath>

#include "experiments/race/timed_companion.hpp"
#include "experiments/studies/inverse_arc_length/problem.hpp"
#include "experiments/studies/trial/trial_study.hpp"

namespace bezierbench::studies {

void InverseArcLengthProblem::draw(std::uint64_t number, Drawn& drawn) const {
  curves_.draw(number, drawn);
  drawn.truth.emplace(drawn.curve, tier_);
  drawn.target = drawn.truth->length_at_share(drawn.trial.t);
}

void InverseArcLengthProblem::judge(const Kernel& /*method*/, Drawn& drawn, double tolerance, const Answer& answer,
                                    std::uint64_t number, Errors& errors) {
  errors.promises.add(answer.converged, answer.evaluations);
  errors.iterations.add(static_cast<double>(answer.iterations));
  if (!std::isfinite(answer.t)) {
    ++errors.promises.non_finite;
    return;
  }
  const double length = drawn.truth->whole();
  const double error = drawn.truth->error_of_length(answer.t, drawn.target, metric::to_24_bits);
  errors.error.add(error);
  errors.relative.add(error == 0 ? 0 : metric::to_24_bits(error / length));
  errors.t_error.add(drawn.truth->error_of_parameter(answer.t, drawn.target, metric::to_24_bits));
  errors.outside += answer.t < 0 || answer.t > 1 ? 1 : 0;
  errors.promises.judge(answer.converged, error, tolerance * length, number);
}

bool InverseArcLengthProblem::is_right(const Kernel& /*method*/, const Drawn& drawn, double tolerance,
                                       const Answer& answer) {
  if (!std::isfinite(answer.t)) return false;
  const double error = drawn.truth->error_of_length(answer.t, drawn.target, metric::to_24_bits);
  return Promises::keeps(error, tolerance * drawn.truth->whole());
}

std::unique_ptr<run::Job> inverse_arc_length_job(const suite::Study& study, const run::JobContext& context) {
  return trial_job<InverseArcLengthProblem>(study, context);
}

constexpr race::TimedProblem timed_inverse_arc_length = race::timed_companion<InverseArcLengthProblem>();

}  // namespace bezierbench::studies
