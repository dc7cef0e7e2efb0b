// SPDX-License-Identifier: MIT
#include "experiments/studies/derivative/derivative.hpp"

#include <cmath>

#include "experiments/race/timed_companion.hpp"
#include "experiments/studies/derivative/problem.hpp"
#include "experiments/studies/trial/trial_study.hpp"

namespace bezierbench::studies {
namespace {

double error_of(const DerivativeProblem::Drawn& drawn, const DerivativeProblem::Answer& answer) {
  return drawn.distance->to(std::span(answer).first(static_cast<std::size_t>(drawn.curve.dimension)));
}

/// The proved bound of the error; infinite where there is none.
double bound_of(const DerivativeKernel& method, const DerivativeProblem::Drawn& drawn) {
  return method.bound == nullptr ? std::numeric_limits<double>::infinity()
                                 : drawn.scale.bound(*method.bound, metric::double_arithmetic);
}

}  // namespace

void DerivativeProblem::draw(std::uint64_t number, Drawn& drawn) const {
  curves_.draw(number, drawn);
  drawn.scale.set(drawn.curve, order_, drawn.trial.t);
  drawn.distance.emplace(drawn.exact.derivative(drawn.curve, order_, drawn.trial.t));
}

void DerivativeProblem::judge(const Kernel& method, const Drawn& drawn, double /*tolerance*/, const Answer& answer,
                              std::uint64_t number, Errors& errors) {
  const double error = error_of(drawn, answer);
  const double bound = bound_of(method, drawn);
  if (!std::isfinite(error)) {
    ++errors.non_finite;
    if (std::isfinite(bound)) errors.violations.add(number);
    return;
  }
  errors.error.add(error);
  metric::add_rounded(drawn.scale.in_bound_units(error, metric::double_arithmetic), errors.error_u);
  if (!std::isfinite(bound)) return;
  ++errors.bounded;
  const double bound_u = drawn.scale.in_bound_units(bound, metric::double_arithmetic);
  if (std::isfinite(bound_u)) errors.bound_u.add(bound_u);
  if (metric::TrialScale::violates(error, bound)) errors.violations.add(number);
}

bool DerivativeProblem::is_right(const Kernel& method, const Drawn& drawn, double /*tolerance*/, const Answer& answer) {
  const double error = error_of(drawn, answer);
  if (!std::isfinite(error)) return false;
  if (method.bound == nullptr)
    return drawn.scale.in_bound_units(error, metric::double_arithmetic) <= judge::half_of_the_digits;
  return !metric::TrialScale::violates(error, bound_of(method, drawn));
}

std::unique_ptr<run::Job> derivative_job(const suite::Study& study, const run::JobContext& context) {
  return trial_job<DerivativeProblem>(study, context);
}

constexpr race::TimedProblem timed_derivative = race::timed_companion<DerivativeProblem>();

}  // namespace bezierbench::studies
