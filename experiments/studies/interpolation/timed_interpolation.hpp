// SPDX-License-Identifier: MIT
// Splines through points as a timing study asks them. Right where every condition is met within the bound or, where
// none is proved, with half of the digits.
#pragma once

#include "core/interpolate/kernel.hpp"
#include "experiments/race/timed_companion.hpp"
#include "experiments/studies/interpolation/interpolation.hpp"
#include "experiments/studies/interpolation/spline_judge.hpp"

namespace bezierbench::studies {

class TimedInterpolation {
 public:
  static constexpr Problem problem = Problem::interpolation;
  static constexpr bool each_data = false;
  using Kernel = InterpolationKernel;
  using Result = std::vector<double>;  ///< control points

  static std::span<const Kernel> kernels(int /*dimension*/) { return interpolation_kernels(); }

  /// Fewer sets of many points, so that a batch is about as long.
  TimedInterpolation(const race::RaceCell& race_cell, const suite::Study& study, std::uint64_t seed)
      : dimension_(race_cell.cell.dimension) {
    const int points = *race_cell.case_values.points;
    sample::Cell drawn = race_cell.cell;  // as the control points of one curve
    drawn.degree = points - 1;
    const sample::Sampler sampler(seed, study.id, drawn);
    sets_.resize(static_cast<std::size_t>(std::clamp(4096 / points, 1, 64)));
    for (std::size_t k = 0; k < sets_.size(); ++k) sampler.draw(k, sets_[k]);
  }

  [[nodiscard]] std::size_t count() const { return sets_.size(); }
  void solve(const Kernel& method, std::size_t k, Result& result) const {
    result = method.interpolate(sets_[k].coefficients, dimension_);
  }
  [[nodiscard]] bool is_right(const Kernel& method, std::size_t k, const Result& result) const {
    SplineErrors errors;
    const double bound = method.residual_bound > 0 ? method.residual_bound : race::half_of_the_digits;
    SplineJudge(sets_[k].coefficients, dimension_, false).judge(result, bound, k, errors);
    return errors.violations == 0 && errors.non_finite == 0;
  }

 private:
  int dimension_;
  std::vector<sample::Trial> sets_;
};

}  // namespace bezierbench::studies
