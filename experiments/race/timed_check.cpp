// SPDX-License-Identifier: MIT
#include "experiments/race/timed_check.hpp"

#include <cmath>

#include "core/basis/amplification.hpp"
#include "experiments/judge/scalar_facts.hpp"
#include "experiments/judge/workspace.hpp"
#include "experiments/metric/trial_scale.hpp"
#include "reference/exact_curve.hpp"

namespace bezierbench::race {
namespace {

/// The accuracy that is required of a method without a proved bound. Of these, interpolation at uniform nodes loses
/// most: its Lebesgue constant grows like 2^n / (e n ln n) (Trefethen, Approximation Theory and Approximation Practice,
/// theorem 15.2).
ErrorBound bound_without_proof(Form form) {
  return {
      .text = "",
      .amplification = form == Form::power ? Amplification::forward_substitution : Amplification::bernstein_to_power,
      .factor = [](int n, double) { return 64.0 * (n + 1) * integer_power(2.0, n); },
      .underflow = [](int n) { return integer_power(4.0, n); },
      .underflow_scales_with_coefficients = true};
}

/// The given curve in double, exactly.
std::vector<double> widened(std::span<const float> values) { return {values.begin(), values.end()}; }
std::span<const double> widened(std::span<const double> values) { return values; }

}  // namespace

template <class Scalar>
JudgedPoints<Scalar> judge(const Kernel<Scalar>& kernel, suite::Mode mode, const Inputs<Scalar>& inputs) {
  constexpr auto arithmetic = judge::ScalarFacts<Scalar>::arithmetic;
  reference::ExactCurve exact;
  metric::TrialScale scale;
  judge::PreparedStorage storage;
  const auto dimension = static_cast<std::size_t>(inputs.dimension);
  JudgedPoints<Scalar> judged{std::vector<Scalar>(inputs.t.size() * dimension), true};
  const ErrorBound allowed = kernel.info->bound.value_or(bound_without_proof(inputs.form));
  for (std::size_t k = 0; k < inputs.t.size(); ++k) {
    const auto curve = inputs.curve_of(k, mode);
    const auto point = std::span(judged.points).subspan(k * dimension, dimension);
    judge::evaluate_once<Scalar>(kernel, curve, inputs.t[k], storage, point);

    const auto coefficients = widened(curve.coefficients);
    const auto weights = widened(curve.weights);
    const CurveView<double> given{curve.form, curve.dimension, curve.degree, coefficients, weights};
    const auto t = static_cast<double>(inputs.t[k]);
    scale.set(given, t);
    const double error = reference::Distance(exact.point(given, t)).to(widened(std::span<const Scalar>(point)));
    double bound = scale.bound(allowed, arithmetic);
    if (!std::isfinite(bound)) bound = scale.bound(bound_without_proof(inputs.form), arithmetic);
    judged.right = judged.right && std::isfinite(error) && !metric::TrialScale::violates(error, bound);
  }
  return judged;
}

template JudgedPoints<float> judge<float>(const Kernel<float>&, suite::Mode, const Inputs<float>&);
template JudgedPoints<double> judge<double>(const Kernel<double>&, suite::Mode, const Inputs<double>&);

}  // namespace bezierbench::race
