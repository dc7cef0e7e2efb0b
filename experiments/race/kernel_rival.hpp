// SPDX-License-Identifier: MIT
// A kernel as a rival in one of the timing modes, over inputs that were drawn and judged beforehand.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "core/batch/batch.hpp"
#include "core/evaluate/kernel/kernel.hpp"
#include "experiments/judge/trial_inputs.hpp"
#include "experiments/race/rounds.hpp"
#include "experiments/sample/draw.hpp"
#include "experiments/suite/suite.hpp"

namespace bezierbench::race {

/// The curves and parameters of a cell: `one_shot` uses curve k with t k; the other modes use the first curve only.
template <class Scalar>
struct Inputs {
  Form form = Form::bernstein;
  int dimension = 2;
  int degree = 0;
  std::vector<std::vector<Scalar>> curves;   ///< coefficients point by point
  std::vector<Scalar> t;                     ///< as many as curves
  std::vector<std::vector<Scalar>> weights;  ///< as many as curves, if these are rational

  [[nodiscard]] CurveView<Scalar> curve(std::size_t k) const {
    CurveView<Scalar> view{form, dimension, degree, curves[k]};
    if (form == Form::rational) view.weights = weights[k];
    return view;
  }
  /// The curve of t[k].
  [[nodiscard]] CurveView<Scalar> curve_of(std::size_t k, suite::Mode mode) const {
    return curve(mode == suite::Mode::one_shot ? k : 0);
  }
};

/// The rival. `judged` are the points that every run must reproduce bit for bit: points[k * dimension + axis] is the
/// point at t[k]. `inputs` must outlive it. In mode `batch` the kernel's best batch kernel on this processor runs,
/// which writes the points axis by axis, or where there is none the kernel itself. In mode `one_shot` a method that
/// takes longer than several rounds for all inputs gets the first ones only, as many as fill a round, at least eight.
template <class Scalar>
Rival kernel_rival(const Kernel<Scalar>& kernel, suite::Mode mode, const Inputs<Scalar>& inputs,
                   std::vector<Scalar> judged);

/// An empty kernel in the same mode: what a call costs. It copies t to every coordinate, in mode `batch` of the first
/// point only.
template <class Scalar>
Rival call_rival(suite::Mode mode, const Inputs<Scalar>& inputs);

// The inputs on which the methods of a cell are timed, its first trials, and the check before timing: whether the
// points of a method are near the exact ones.

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
