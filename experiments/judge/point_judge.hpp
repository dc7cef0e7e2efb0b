// SPDX-License-Identifier: MIT
// Judges one method at one input. A search maximises this error, and a replay recomputes it.
#pragma once

#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <span>

#include "core/evaluate/kernel/prepared_state.hpp"
#include "experiments/judge/scalar_facts.hpp"
#include "experiments/judge/trial_inputs.hpp"
#include "experiments/metric/tally.hpp"
#include "reference/error/trial_scale.hpp"
#include "reference/true_point.hpp"

namespace bezierbench::judge {

/// Computed with the same roundings as a row of accuracy.csv.
struct PointVerdict {
  std::array<double, reference::max_dimension> point{};
  bool finite = false;                 ///< the next two are set only if it is
  double error = 0;                    ///< to 24 bits
  double error_u = 0;                  ///< to 24 bits; infinite where p~ is 0
  std::optional<double> bound_u = {};  ///< at this input; empty where nothing is proved
  bool violates = false;               ///< the error, infinite where the point is not finite, is beyond the bound
};

/// Keeps its scratch between calls, so every thread needs its own object.
template <class Scalar>
class PointJudge {
 public:
  /// No verdict depends on the tier.
  explicit PointJudge(reference::Tier tier = reference::Tier::exact) : tier_(tier) {}

  PointVerdict judge(const Kernel<Scalar>& kernel, const TrialInputs<Scalar>& inputs) {
    const auto d = static_cast<std::size_t>(kernel.dimension);
    std::array<Scalar, reference::max_dimension> point{};
    const Scalar t = inputs.t();
    PreparedState<Scalar>(kernel, inputs.curve()).evaluate({&t, 1}, point.data());
    return judge(kernel, inputs, std::span<const Scalar>(point.data(), d));
  }

  /// Judges a point that was computed elsewhere. Of the kernel only what describes it is used.
  PointVerdict judge(const Kernel<Scalar>& kernel, const TrialInputs<Scalar>& inputs, std::span<const Scalar> point) {
    const std::size_t d = point.size();
    PointVerdict verdict;
    verdict.finite = true;
    for (std::size_t axis = 0; axis < d; ++axis) {
      verdict.point[axis] = static_cast<double>(point[axis]);
      verdict.finite = verdict.finite && std::isfinite(point[axis]);
    }
    reference::TruePoint truth(exact_, inputs.true_curve(), inputs.true_t(), certified_point(inputs));
    if (!truth.exists()) {
      verdict.finite = false;
      return verdict;
    }
    const double error = verdict.finite ? truth.distance({verdict.point.data(), d}) : infinite;
    verdict.finite = std::isfinite(error);
    weigh(kernel, inputs, error, truth.length(), verdict);
    return verdict;
  }

  /// The true point; valid until the next call.
  const reference::ExactPoint& truth(const TrialInputs<Scalar>& inputs) {
    return exact_.point(inputs.true_curve(), inputs.true_t());
  }

 private:
  static constexpr double infinite = std::numeric_limits<double>::infinity();

  std::optional<reference::CertifiedPoint> certified_point(const TrialInputs<Scalar>& inputs) {
    const auto curve = inputs.true_curve();
    if (tier_ != reference::Tier::certified || !reference::CertifiedPoints::applies(curve.form)) return std::nullopt;
    if (!certified_ || !certified_->is_for(curve.form, curve.dimension, curve.degree))
      certified_.emplace(curve.form, curve.dimension, curve.degree);
    certified_->load(0, curve, inputs.true_t());
    certified_->evaluate_one();
    return certified_->point(0);
  }

  void weigh(const Kernel<Scalar>& kernel, const TrialInputs<Scalar>& inputs, double error, double length,
             PointVerdict& verdict) {
    constexpr auto arithmetic = ScalarFacts<Scalar>::arithmetic;
    scale_.set(inputs.true_curve(), inputs.true_t());
    if (verdict.finite) {
      verdict.error = error;
      verdict.error_u = metric::to_24_bits(scale_.in_bound_units(error, arithmetic));
    }
    if (!kernel.info->bound) return;
    const reference::BoundAtDegree bound(*kernel.info->bound, inputs.true_curve().degree, arithmetic);
    const auto checked = scale_.check(error, bound, arithmetic, length);
    if (!checked) return;
    verdict.bound_u = checked->bound_u;
    verdict.violates = checked->violated;
  }

  reference::Tier tier_;
  std::optional<reference::CertifiedPoints> certified_;  ///< of the last form, dimension and degree
  reference::ExactCurve exact_;
  reference::TrialScale scale_;
};

}  // namespace bezierbench::judge
