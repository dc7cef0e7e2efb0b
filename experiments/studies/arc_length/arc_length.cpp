// SPDX-License-Identifier: MIT
// Studies of kind `arc_length`: lengths of random curves over each interval of t, to each tolerance, against the true
// lengths. A method that reports that it kept its tolerance and did not fails the run. Rows of methods that are not
// bit-stable go to arc_length_unstable.csv.

#include <cmath>

#include "experiments/studies/arc_length/problem.hpp"
#include "experiments/studies/trial/companion_kind.hpp"
#include "experiments/suite/kind.hpp"

namespace bezierbench::studies {

void ArcLengthProblem::judge(const Kernel& /*method*/, const Drawn& drawn, double tolerance, const Answer& answer,
                             std::uint64_t number, Errors& errors) {
  if (!drawn.truth) return;  // a pole
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
  return !drawn.truth ||
         Promises::keeps(drawn.truth->error_of(answer.length, metric::to_24_bits), tolerance * drawn.truth->length());
}

namespace {

constexpr std::array arc_length_fields{suite::field<&suite::Study::tolerance>(
    suite::tolerance_key("tolerances that the methods are given, relative to the length", "[1e-3, 1e-6]"))};

}  // namespace

extern constexpr StudyKind arc_length_kind =
    companion_kind<ArcLengthProblem>({.id = "arc_length",
                                      .about = "errors of arc lengths, and whether tolerances are kept",
                                      .own = arc_length_fields,
                                      .methods_example = "[\"gauss_legendre_adaptive\"]",
                                      .inputs = {.forms = suite::forms_with_control_points,
                                                 .forms_reason = "lengths are those of Bezier curves",
                                                 .double_only = true,
                                                 .parameters = suite::Parameters::from_0_to_1,
                                                 .parameters_reason = "the part to be measured"}});

}  // namespace bezierbench::studies
