// SPDX-License-Identifier: MIT
// Derivatives as a timing study asks them. Right where they keep their bound or, where none is proved, half of their
// digits.
#pragma once

#include <array>
#include <cmath>

#include "core/derivative/kernel.hpp"
#include "experiments/judge/drawn_curves.hpp"
#include "experiments/metric/derivative_scale.hpp"
#include "experiments/race/timed_companion.hpp"
#include "experiments/studies/derivative/derivative.hpp"

namespace bezierbench::studies {

class TimedDerivative {
 public:
  static constexpr Problem problem = Problem::derivative;
  static constexpr bool each_data = false;
  using Kernel = DerivativeKernel;
  using Result = std::array<double, 3>;  ///< coordinates; those beyond the dimension are not written

  static std::span<const Kernel> kernels(int dimension) { return derivative_kernels(dimension); }

  TimedDerivative(const race::RaceCell& race_cell, const suite::Study& study, std::uint64_t seed)
      : curves_(study, race_cell.cell, seed, 256), order_(*race_cell.case_values.order) {}

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
    if (method.bound == nullptr)
      return scale.in_bound_units(error, metric::double_arithmetic) <= race::half_of_the_digits;
    return !metric::TrialScale::violates(error, scale.bound(*method.bound, metric::double_arithmetic));
  }

 private:
  judge::DrawnCurves curves_;
  int order_;
};

}  // namespace bezierbench::studies
