// SPDX-License-Identifier: MIT
// Judges one method at one input. A search maximises this error, and a replay recomputes it.
#pragma once

#include <array>
#include <cmath>
#include <optional>
#include <span>

#include "core/evaluate/kernel.hpp"
#include "experiments/judge/scalar_facts.hpp"
#include "experiments/judge/trial_inputs.hpp"
#include "experiments/judge/workspace.hpp"
#include "experiments/metric/tally.hpp"
#include "experiments/metric/trial_scale.hpp"
#include "reference/exact_curve.hpp"

namespace bezierbench::judge {

/// Computed with the same roundings as a row of accuracy.csv.
struct PointVerdict {
  std::array<double, reference::max_dimension> point{};
  bool finite = false;                 ///< the members below are set only if it is
  double error = 0;                    ///< to 24 bits
  double error_u = 0;                  ///< to 24 bits; infinite where p~ is 0
  std::optional<double> bound_u = {};  ///< at this input; empty where nothing is proved
  bool violates = false;
};

/// Keeps its scratch between calls, so every thread needs its own object.
template <class Scalar>
class PointJudge {
 public:
  PointVerdict judge(const Kernel<Scalar>& kernel, const TrialInputs<Scalar>& inputs) {
    const auto d = static_cast<std::size_t>(kernel.dimension);
    std::array<Scalar, reference::max_dimension> point{};
    evaluate_once(kernel, inputs.curve(), inputs.t(), storage_, std::span<Scalar>(point.data(), d));
    PointVerdict verdict;
    verdict.finite = true;
    for (std::size_t axis = 0; axis < d; ++axis) {
      verdict.point[axis] = static_cast<double>(point[axis]);
      verdict.finite = verdict.finite && std::isfinite(point[axis]);
    }
    const auto& exact = truth(inputs);
    verdict.finite = verdict.finite && exact.exists();
    if (!verdict.finite) return verdict;
    const reference::Distance distance(exact);
    verdict.error = distance.to({verdict.point.data(), d});
    verdict.finite = std::isfinite(verdict.error);
    if (verdict.finite) weigh(kernel, inputs, distance.of_origin(kernel.dimension), verdict);
    return verdict;
  }

  /// The true point; valid until the next call.
  const reference::ExactPoint& truth(const TrialInputs<Scalar>& inputs) {
    return exact_.point(inputs.true_curve(), inputs.true_t());
  }

 private:
  void weigh(const Kernel<Scalar>& kernel, const TrialInputs<Scalar>& inputs, double length, PointVerdict& verdict) {
    constexpr auto arithmetic = ScalarFacts<Scalar>::arithmetic;
    scale_.set(inputs.true_curve(), inputs.true_t());
    verdict.error_u = metric::to_24_bits(scale_.in_bound_units(verdict.error, arithmetic));
    if (!kernel.info->bound) return;
    const metric::BoundAtDegree bound(*kernel.info->bound, inputs.true_curve().degree, arithmetic);
    const auto checked = scale_.check(verdict.error, bound, arithmetic, length);
    if (!checked) return;
    verdict.bound_u = checked->bound_u;
    verdict.violates = checked->violated;
  }

  PreparedStorage storage_;
  reference::ExactCurve exact_;
  metric::TrialScale scale_;
};

}  // namespace bezierbench::judge
