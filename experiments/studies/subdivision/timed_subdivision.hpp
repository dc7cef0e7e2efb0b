// SPDX-License-Identifier: MIT
// Subdivision as a timing study asks it. Right where every control point keeps its bound or, where none is proved, half
// of its digits.
#pragma once

#include <cmath>
#include <memory>
#include <vector>

#include "experiments/judge/method_choice.hpp"
#include "experiments/metric/trial_scale.hpp"
#include "experiments/race/timed_companion.hpp"
#include "experiments/sample/draw.hpp"
#include "experiments/studies/subdivision/split_truth.hpp"
#include "experiments/studies/subdivision/subdivision.hpp"

namespace bezierbench::studies {

class TimedSubdivision {
 public:
  static constexpr Problem problem = Problem::subdivision;
  static constexpr bool each_data = false;
  using Kernel = SplitKernel;
  using Result = std::vector<double>;  ///< the numbers of the left half, then those of the right one

  static std::span<const Kernel> kernels(int dimension) { return split_kernels(dimension); }

  TimedSubdivision(const race::RaceCell& race_cell, const suite::Study& study, std::uint64_t seed)
      : form_(study.curve), cell_(race_cell.cell), trials_(64) {
    const sample::Sampler sampler(seed, study.id, cell_);
    for (std::size_t k = 0; k < trials_.size(); ++k) {
      sampler.draw(k, trials_[k]);
      truths_.push_back(std::make_unique<SplitTruth>(curve_of(k), trials_[k].t));
    }
  }

  [[nodiscard]] std::size_t count() const { return trials_.size(); }
  void solve(const Kernel& method, std::size_t k, Result& result) const {
    const auto curve = curve_of(k);
    const auto columns = static_cast<std::size_t>(split_columns(curve.form, curve.dimension));
    const std::size_t size = (static_cast<std::size_t>(curve.degree) + 1) * columns;
    result.resize(2 * size);  // once
    method.split(curve, trials_[k].t, result.data(), result.data() + size);
  }
  [[nodiscard]] bool is_right(const Kernel& method, std::size_t k, const Result& result) const {
    const auto curve = curve_of(k);
    const ComputedHalves computed(curve, result);
    if (!computed.all_finite()) return false;
    bool right = true;
    for (const Side side : sides)
      for (int i = 0; i <= curve.degree; ++i) {
        const auto control = computed.control(side, i);
        const auto point = control.first(static_cast<std::size_t>(curve.dimension));
        right = right && near_enough(truths_[k]->of_point(method.bound, side, i, point));
        if (curve.form == Form::rational)
          right = right && near_enough(truths_[k]->of_weight(method.bound, side, i, control.back()));
      }
    return right;
  }

 private:
  static bool near_enough(const SplitError& error) {
    return std::isfinite(error.bound) ? !metric::TrialScale::violates(error.error, error.bound)
                                      : error.error_u <= race::half_of_the_digits;
  }

  [[nodiscard]] CurveView<double> curve_of(std::size_t k) const {
    return {form_, cell_.dimension, cell_.degree, trials_[k].coefficients, trials_[k].weights};
  }

  Form form_;
  sample::Cell cell_;
  std::vector<sample::Trial> trials_;
  std::vector<std::unique_ptr<SplitTruth>> truths_;
};

}  // namespace bezierbench::studies
