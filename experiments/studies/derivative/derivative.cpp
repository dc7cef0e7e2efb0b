// SPDX-License-Identifier: MIT
// Studies of kind `derivative`: derivatives of random curves at random t, of each order, against the exact ones.

#include <cmath>

#include "experiments/studies/derivative/problem.hpp"
#include "experiments/studies/trial/companion_kind.hpp"
#include "experiments/suite/kind.hpp"

namespace bezierbench::studies {
namespace {

double error_of(const DerivativeProblem::Drawn& drawn, const DerivativeProblem::Answer& answer) {
  return drawn.distance->to(std::span(answer).first(static_cast<std::size_t>(drawn.curve.dimension)));
}

/// The proved bound of the error; infinite where there is none.
double bound_of(const DerivativeKernel& method, const DerivativeProblem::Drawn& drawn) {
  return method.bound == nullptr ? std::numeric_limits<double>::infinity()
                                 : drawn.scale.bound(*method.bound, reference::double_arithmetic);
}

}  // namespace

void DerivativeProblem::draw(std::uint64_t number, Drawn& drawn) const {
  curves_.draw(number, drawn);
  drawn.scale.set(drawn.curve, order_, drawn.trial.t);
  const auto& truth = drawn.exact.derivative(drawn.curve, order_, drawn.trial.t);
  drawn.distance.reset();
  if (truth.exists()) drawn.distance.emplace(truth);
}

void DerivativeProblem::judge(const Kernel& method, const Drawn& drawn, double /*tolerance*/, const Answer& answer,
                              std::uint64_t number, Errors& errors) {
  if (!drawn.distance) return;  // the weights sum to zero
  const double error = error_of(drawn, answer);
  const double bound = bound_of(method, drawn);
  if (!std::isfinite(error)) {
    ++errors.non_finite;
    if (std::isfinite(bound)) errors.violations.add(number);
    return;
  }
  errors.error.add(error);
  metric::add_rounded(drawn.scale.in_bound_units(error, reference::double_arithmetic), errors.error_u);
  if (!std::isfinite(bound)) return;
  ++errors.bounded;
  const double bound_u = drawn.scale.in_bound_units(bound, reference::double_arithmetic);
  if (std::isfinite(bound_u)) errors.bound_u.add(bound_u);
  if (reference::TrialScale::violates(error, bound)) errors.violations.add(number);
}

bool DerivativeProblem::is_right(const Kernel& method, const Drawn& drawn, double /*tolerance*/, const Answer& answer) {
  if (!drawn.distance) return true;
  const double error = error_of(drawn, answer);
  if (!std::isfinite(error)) return false;
  if (method.bound == nullptr)
    return drawn.scale.in_bound_units(error, reference::double_arithmetic) <= judge::half_of_the_digits;
  return !reference::TrialScale::violates(error, bound_of(method, drawn));
}

namespace {

constexpr std::array derivative_fields{suite::field<&suite::Study::order>(suite::order_key)};

}  // namespace

extern constexpr StudyKind derivative_kind =
    companion_kind<DerivativeProblem>({.id = "derivative",
                                       .about = "errors of derivatives at one parameter",
                                       .own = derivative_fields,
                                       .methods_example = "[\"differences_horner\"]",
                                       .inputs = {.double_only = true}});

}  // namespace bezierbench::studies
