// SPDX-License-Identifier: MIT
#include "experiments/studies/timed_check.hpp"

#include <cmath>

#include "core/basis/amplification.hpp"
#include "experiments/metric/trial_scale.hpp"
#include "experiments/studies/workspace.hpp"
#include "reference/exact_curve.hpp"

namespace bezierbench::studies {
namespace {

/// What is asked of a method where no bound is proved.
ErrorBound lenient_bound(Form form) {
  return {
      .text = "",
      .amplification = form == Form::power ? Amplification::forward_substitution : Amplification::bernstein_to_power,
      .factor = [](int n, double) { return 64.0 * (n + 1); },
      .underflow = [](int n) { return integer_power(4.0, n); },
      .underflow_scales_with_coefficients = true};
}

}  // namespace

bool agrees_with_reference(const Kernel<double>& kernel, suite::Mode mode, const timing::Inputs& inputs) {
  reference::ExactCurve exact;
  metric::TrialScale scale;
  PreparedStorage storage;
  std::vector<double> point(static_cast<std::size_t>(inputs.dimension));
  const ErrorBound allowed = kernel.info->bound.value_or(lenient_bound(inputs.form));
  for (std::size_t k = 0; k < inputs.t.size(); ++k) {
    const auto curve = inputs.curve(mode == suite::Mode::one_shot ? k : 0);
    evaluate_once<double>(kernel, curve, inputs.t[k], storage, point);
    scale.set(curve, inputs.t[k]);
    const double error = reference::Distance(exact.point(curve, inputs.t[k])).to(point);
    double bound = scale.bound(allowed, metric::double_arithmetic);
    if (!std::isfinite(bound)) bound = scale.bound(lenient_bound(inputs.form), metric::double_arithmetic);
    if (!std::isfinite(error) || metric::TrialScale::violates(error, bound)) return false;
  }
  return true;
}

}  // namespace bezierbench::studies
