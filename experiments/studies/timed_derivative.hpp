// SPDX-License-Identifier: MIT
// Derivatives as a timing study asks them. Right where they keep their bound or, where none is proved, half of their
// digits.
#pragma once

#include <array>
#include <cmath>

#include "core/derivative/kernel.hpp"
#include "experiments/metric/derivative_scale.hpp"
#include "experiments/studies/derivative.hpp"
#include "experiments/studies/drawn_curves.hpp"
#include "experiments/studies/timed_companion.hpp"

namespace bezierbench::studies {

class TimedDerivative {
 public:
  static constexpr Problem problem = Problem::derivative;
  static constexpr Asks asks{.order = true};
  using Kernel = DerivativeKernel;
  using Result = std::array<double, 3>;  ///< coordinates; those beyond the dimension are not written

  static std::span<const Kernel> kernels(int dimension) { return derivative_kernels(dimension); }
  static void check(const suite::Study& study) { check_derivatives(study); }

  TimedDerivative(const Heat& heat, const suite::Study& study, std::uint64_t seed)
      : curves_(study, heat.cell, seed, 256), order_(*heat.asked.order) {}

  [[nodiscard]] std::size_t count() const { return curves_.size(); }
  void solve(const Kernel& method, std::size_t k, Result& result) const {
    method.derivative(curves_.curve(k), order_, curves_.t(k), result.data());
  }
  [[nodiscard]] bool is_right(const Kernel& method, std::size_t k, const Result& result) const {
    const auto curve = curves_.curve(k);
    metric::DerivativeScale scale;
    scale.set(curve, order_, curves_.t(k));
    const reference::Distance distance(reference::ExactCurve().derivative(curve, order_, curves_.t(k)));
    const double error = distance.to(std::span(result).first(static_cast<std::size_t>(curve.dimension)));
    if (!std::isfinite(error)) return false;
    if (method.bound == nullptr) return scale.in_bound_units(error, metric::double_arithmetic) <= lenient_bound;
    return !metric::TrialScale::violates(error, scale.bound(*method.bound, metric::double_arithmetic));
  }

 private:
  DrawnCurves curves_;
  int order_;
};

}  // namespace bezierbench::studies
