// SPDX-License-Identifier: MIT
// A kernel as a rival in one of the timing modes, over inputs that were drawn and judged beforehand.
#pragma once

#include <vector>

#include "core/batch/batch.hpp"
#include "core/evaluate/kernel/kernel.hpp"
#include "experiments/race/rounds.hpp"
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

}  // namespace bezierbench::race
