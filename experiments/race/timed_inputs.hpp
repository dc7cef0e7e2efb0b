// SPDX-License-Identifier: MIT
// The inputs on which the methods of a cell are timed: its first trials.
#pragma once

#include <cstddef>
#include <cstdint>

#include "experiments/judge/trial_inputs.hpp"
#include "experiments/race/kernel_rival.hpp"
#include "experiments/sample/draw.hpp"

namespace bezierbench::race {

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
