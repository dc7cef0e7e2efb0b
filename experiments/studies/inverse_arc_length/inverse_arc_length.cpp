// SPDX-License-Identifier: MIT
// Studies of kind `inverse_arc_length`: the parameter at a share of the length of random curves, to each tolerance,
// against the true parameter. The share is the trial's t, drawn from the interval of t. A method that reports that it
// kept its tolerance and did not fails the run. Writes inverse_arc_length.csv, and for each study spacing.csv: the
// curve of its first trial with points at equal steps of t and at equal steps of the length.

#include <cmath>

#include "experiments/race/timed_companion.hpp"
#include "experiments/studies/inverse_arc_length/problem.hpp"
#include "experiments/studies/roster.hpp"
#include "experiments/studies/trial/trial_study.hpp"
#include "experiments/suite/keys.hpp"

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

namespace {

constexpr std::array inverse_arc_length_fields{suite::field<&suite::Study::tolerance>(suite::tolerance_key(
    "tolerances that the methods are given, relative to the length of the whole curve", "[1e-3, 1e-6]"))};

suite::Finding check_inverse_arc_length(const suite::Study& study, const suite::Vocabulary& /*known*/) {
  return suite::check_tolerances(study.tolerance);
}

}  // namespace

extern constexpr StudyKind inverse_arc_length_kind{
    .asks = {.id = "inverse_arc_length",
             .about = "errors of the parameter at a length, and whether tolerances are kept",
             .own = inverse_arc_length_fields,
             .methods_example = "[\"bracketed_newton\"]",
             .inputs = {.forms = suite::bernstein_form,
                        .forms_reason = "lengths are those of polynomial Bezier curves",
                        .double_only = true,
                        .parameters = suite::Parameters::from_0_to_1,
                        .parameters_reason = "the share of the length at which t is sought"},
             .problem = Problem::inverse_arc_length,
             .check = check_inverse_arc_length},
    .make = trial_job<InverseArcLengthProblem>,
    .tables = {"inverse_arc_length", "spacing"},
    .timed = race::timed_companion<InverseArcLengthProblem>()};

}  // namespace bezierbench::studies
