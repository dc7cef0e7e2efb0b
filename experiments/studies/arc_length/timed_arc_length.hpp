// SPDX-License-Identifier: MIT
// Arc lengths as a timing study asks them. Right where they keep the tolerance.
#pragma once

#include <array>

#include "experiments/judge/drawn_curves.hpp"
#include "experiments/judge/methods.hpp"
#include "experiments/race/timed_companion.hpp"
#include "experiments/studies/tolerance_study.hpp"
#include "reference/true_length.hpp"

namespace bezierbench::studies {

class TimedArcLength {
 public:
  static constexpr Problem problem = Problem::arc_length;
  static constexpr bool each_data = false;
  using Kernel = ArcLengthKernel;
  using Result = std::array<double, 2>;  ///< length, evaluations

  static std::span<const Kernel> kernels(int dimension) { return judge::arc_length_methods(dimension); }

  TimedArcLength(const race::RaceCell& race_cell, const suite::Study& study, std::uint64_t seed)
      : curves_(study, race_cell.cell, seed, 32), tolerance_(*race_cell.case_values.tolerance) {
    for (std::size_t k = 0; k < count(); ++k)
      truths_.emplace_back(curves_.curve(k), curves_.cell().t_interval.min, curves_.cell().t_interval.max);
  }

  [[nodiscard]] std::size_t count() const { return curves_.size(); }
  void solve(const Kernel& method, std::size_t k, Result& result) const {
    const auto [from, to] = curves_.cell().t_interval;
    const auto length = method.measure(curves_.curve(k), from, to, tolerance_);
    result = {length.length, static_cast<double>(length.evaluations)};
  }
  [[nodiscard]] bool is_right(const Kernel& /*method*/, std::size_t k, const Result& result) const {
    return Promises::keeps(truths_[k].error_of(result[0]), tolerance_ * truths_[k].value().convert_to<double>());
  }

 private:
  judge::DrawnCurves curves_;
  double tolerance_;
  std::vector<reference::TrueLength> truths_;
};

}  // namespace bezierbench::studies
