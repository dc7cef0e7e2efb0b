// SPDX-License-Identifier: MIT
// Parameters at a length as a timing study asks them. Right where the length up to there keeps the tolerance.
#pragma once

#include <array>
#include <cmath>

#include "core/arc_length/inverse/kernel.hpp"
#include "experiments/judge/drawn_curves.hpp"
#include "experiments/race/timed_companion.hpp"
#include "experiments/studies/tolerance_study.hpp"
#include "reference/length_along.hpp"

namespace bezierbench::studies {

class TimedInverseArcLength {
 public:
  static constexpr Problem problem = Problem::inverse_arc_length;
  static constexpr bool each_data = false;
  using Kernel = InverseArcLengthKernel;
  using Result = std::array<double, 3>;  ///< t, iterations, evaluations

  static std::span<const Kernel> kernels(int dimension) { return inverse_arc_length_kernels(dimension); }

  /// The length that is sought is the share t of the whole, as in a study of errors.
  TimedInverseArcLength(const race::RaceCell& race_cell, const suite::Study& study, std::uint64_t seed)
      : curves_(study, race_cell.cell, seed, 32), tolerance_(*race_cell.case_values.tolerance) {
    for (std::size_t k = 0; k < count(); ++k) {
      truths_.emplace_back(curves_.curve(k));
      targets_.push_back(reference::LongReal(curves_.t(k) * truths_[k].whole()).convert_to<double>());
    }
  }

  [[nodiscard]] std::size_t count() const { return curves_.size(); }
  void solve(const Kernel& method, std::size_t k, Result& result) const {
    const auto place = method.solve(curves_.curve(k), targets_[k], tolerance_);
    result = {place.t, static_cast<double>(place.iterations), static_cast<double>(place.evaluations)};
  }
  [[nodiscard]] bool is_right(const Kernel& /*method*/, std::size_t k, const Result& result) const {
    if (!std::isfinite(result[0])) return false;
    const reference::LongReal error = abs(truths_[k].length_to(reference::LongReal(result[0])) - targets_[k]);
    return Promises::keeps(error.convert_to<double>(), tolerance_ * truths_[k].whole().convert_to<double>());
  }

 private:
  judge::DrawnCurves curves_;
  double tolerance_;
  std::vector<reference::LengthAlong> truths_;
  std::vector<double> targets_;
};

}  // namespace bezierbench::studies
