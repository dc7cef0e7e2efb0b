// SPDX-License-Identifier: MIT
// Piecewise fits as a timing study asks them, each kind of data for itself. Right where no data point is farther from
// the curve than the tolerance.
#pragma once

#include <cmath>

#include "core/fit/kernel.hpp"
#include "experiments/race/timed_companion.hpp"
#include "experiments/sample/data_kind.hpp"
#include "experiments/studies/fitting/fitting.hpp"
#include "reference/fit_distance.hpp"

namespace bezierbench::studies {

class TimedFitting {
 public:
  static constexpr Problem problem = Problem::fitting;
  static constexpr bool each_data = true;
  using Kernel = FittingKernel;
  using Result = std::vector<double>;  ///< control points

  static std::span<const Kernel> kernels(int dimension) { return fitting_kernels(dimension); }

  TimedFitting(const race::RaceCell& race_cell, const suite::Study& study, std::uint64_t seed)
      : tolerance_(*race_cell.case_values.tolerance) {
    const sample::Sampler sampler(seed, study.id,
                                  sample::with_displacements(race_cell.cell, *race_cell.case_values.points));
    const auto& kind = *std::ranges::find(sample::data_kinds(), race_cell.case_values.data, &sample::DataKind::id);
    for (std::size_t k = 0; k < 16; ++k) data_.push_back(sample::data_points(kind, sampler, race_cell.cell, k));
  }

  [[nodiscard]] std::size_t count() const { return data_.size(); }
  void solve(const Kernel& method, std::size_t k, Result& result) const {
    result = method.fit(data_[k], tolerance_).control_points;
  }
  [[nodiscard]] bool is_right(const Kernel& method, std::size_t k, const Result& result) const {
    if (!std::ranges::all_of(result, [](double x) { return std::isfinite(x); })) return false;
    const auto fit = method.fit(data_[k], tolerance_);  // where it says that it is near shortens the search
    std::vector<reference::NearPlace> near;
    for (std::size_t i = 0; i < fit.t.size(); ++i) near.push_back({fit.segment[i], fit.t[i]});
    const auto squared = reference::largest_squared_distance(method.dimension, data_[k], result, near);
    const auto allowed = reference::exactly(tolerance_);
    return sgn((squared - allowed * allowed).numerator) <= 0;
  }

 private:
  double tolerance_;
  std::vector<std::vector<double>> data_;
};

}  // namespace bezierbench::studies
