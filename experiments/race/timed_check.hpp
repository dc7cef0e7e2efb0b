// SPDX-License-Identifier: MIT
// The inputs on which the methods of a cell are timed, its first trials, and the check before timing: whether the
// points of a method are near the exact ones.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "experiments/judge/trial_inputs.hpp"
#include "experiments/race/kernel_rival.hpp"
#include "experiments/sample/draw.hpp"

namespace bezierbench::race {

/// The points of a kernel on some inputs, and whether they are right.
template <class Scalar>
struct JudgedPoints {
  std::vector<Scalar> points;  ///< point by point, as kernel_rival() requires them
  bool right = true;           ///< all are finite, and within the method's bound of the exact ones where one is proved
  /// The largest error, in units of u p~, where no bound is proved; metric::allowed_error_u() says what it may be.
  std::optional<double> max_error_u;
};

/// Evaluates one curve and one t at a time.
template <class Scalar>
JudgedPoints<Scalar> judge_points(const Kernel<Scalar>& kernel, suite::Mode mode, const Inputs<Scalar>& inputs);

inline constexpr std::size_t timed_inputs_per_cell = 256;

template <class Scalar>
Inputs<Scalar> timed_inputs(const suite::Study& study, const sample::Cell& cell, std::uint64_t seed) {
  const Form form = study.form;
  Inputs<Scalar> inputs{form, cell.dimension, cell.degree, {}, {}, {}};
  const sample::Sampler sampler(seed, study.id, cell);
  judge::TrialInputs<Scalar> trial(form, cell);
  for (std::size_t k = 0; k < timed_inputs_per_cell; ++k) {
    trial.draw(sampler, k);
    const auto curve = trial.curve();
    inputs.curves.emplace_back(curve.coefficients.begin(), curve.coefficients.end());
    inputs.weights.emplace_back(curve.weights.begin(), curve.weights.end());
    inputs.t.push_back(trial.t());
  }
  return inputs;
}

}  // namespace bezierbench::race
