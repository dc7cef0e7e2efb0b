// SPDX-License-Identifier: MIT
#include "experiments/studies/inverse_arc_length/inverse_arc_length.hpp"

#include <cmath>

#include "experiments/race/timed_companion.hpp"
#include "experiments/studies/inverse_arc_length/problem.hpp"
#include "experiments/studies/trial/trial_study.hpp"

namespace bezierbench::studies {
namespace {

using reference::LongReal;

double rounded(const LongReal& error) { return metric::to_24_bits(error.convert_to<double>()); }

}  // namespace

void InverseArcLengthProblem::draw(std::uint64_t number, Drawn& drawn) const {
  curves_.draw(number, drawn);
  drawn.truth.emplace(drawn.curve);
  drawn.target = LongReal(drawn.trial.t * drawn.truth->whole()).convert_to<double>();
  drawn.exact_parameter.reset();
}

void InverseArcLengthProblem::judge(const Kernel& /*method*/, Drawn& drawn, double tolerance, const Answer& answer,
                                    std::uint64_t number, Errors& errors) {
  errors.promises.add(answer.converged, answer.evaluations);
  errors.iterations.add(static_cast<double>(answer.iterations));
  if (!std::isfinite(answer.t)) {
    ++errors.promises.non_finite;
    return;
  }
  if (!drawn.exact_parameter) drawn.exact_parameter = drawn.truth->parameter_at(drawn.target);
  const auto length = drawn.truth->whole().convert_to<double>();
  const double error = rounded(drawn.truth->distance(LongReal(answer.t), drawn.target));
  errors.error.add(error);
  errors.relative.add(error == 0 ? 0 : metric::to_24_bits(error / length));
  errors.t_error.add(rounded(abs(LongReal(answer.t) - *drawn.exact_parameter)));
  errors.outside += answer.t < 0 || answer.t > 1 ? 1 : 0;
  errors.promises.judge(answer.converged, error, tolerance * length, number);
}

bool InverseArcLengthProblem::is_right(const Kernel& /*method*/, const Drawn& drawn, double tolerance,
                                       const Answer& answer) {
  if (!std::isfinite(answer.t)) return false;
  const LongReal error = abs(drawn.truth->length_to(LongReal(answer.t)) - drawn.target);
  return Promises::keeps(error.convert_to<double>(), tolerance * drawn.truth->whole().convert_to<double>());
}

std::unique_ptr<run::Job> inverse_arc_length_job(const suite::Study& study, const run::JobContext& context) {
  return trial_job<InverseArcLengthProblem>(study, context);
}

constexpr race::TimedProblem timed_inverse_arc_length = race::timed_companion<InverseArcLengthProblem>();

}  // namespace bezierbench::studies
