// SPDX-License-Identifier: MIT
#include "experiments/race/timed_check.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "experiments/judge/scalar_facts.hpp"
#include "experiments/judge/workspace.hpp"
#include "reference/error/trial_scale.hpp"
#include "reference/exact_curve.hpp"

namespace bezierbench::race {
namespace {

/// The given curve in double, exactly.
std::vector<double> widened(std::span<const float> values) { return {values.begin(), values.end()}; }
std::span<const double> widened(std::span<const double> values) { return values; }

}  // namespace

template <class Scalar>
JudgedPoints<Scalar> judge_points(const Kernel<Scalar>& kernel, suite::Mode mode, const Inputs<Scalar>& inputs) {
  constexpr auto arithmetic = judge::ScalarFacts<Scalar>::arithmetic;
  reference::ExactCurve exact;
  reference::TrialScale scale;
  judge::PreparedStorage storage;
  const auto dimension = static_cast<std::size_t>(inputs.dimension);
  JudgedPoints<Scalar> judged{std::vector<Scalar>(inputs.t.size() * dimension), true, std::nullopt};
  const auto& proved = kernel.info->bound;
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
    judged.right = judged.right && std::isfinite(error);
    const double bound = proved ? scale.bound(*proved, arithmetic) : std::numeric_limits<double>::infinity();
    if (std::isfinite(bound))
      judged.right = judged.right && !reference::TrialScale::violates(error, bound);
    else
      judged.max_error_u = std::max(judged.max_error_u.value_or(0), scale.in_bound_units(error, arithmetic));
  }
  return judged;
}

template JudgedPoints<float> judge_points<float>(const Kernel<float>&, suite::Mode, const Inputs<float>&);
template JudgedPoints<double> judge_points<double>(const Kernel<double>&, suite::Mode, const Inputs<double>&);

}  // namespace bezierbench::race
