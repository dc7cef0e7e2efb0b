// SPDX-License-Identifier: MIT
// A kernel as a contestant in one of the timing modes, over inputs that were drawn and judged beforehand.
#pragma once

#include <memory>
#include <vector>

#include "core/evaluate/kernel.hpp"
#include "experiments/suite/suite.hpp"
#include "experiments/timing/race.hpp"

namespace bezierbench::timing {

/// The curves and parameters of a cell: `one_shot` uses curve k with t k; the other modes use the first curve only.
struct Inputs {
  Form form = Form::bernstein;
  int dimension = 2;
  int degree = 0;
  std::vector<std::vector<double>> curves;   ///< coefficients point by point
  std::vector<double> t;                     ///< as many as curves
  std::vector<std::vector<double>> weights;  ///< as many as curves, if these are rational

  [[nodiscard]] CurveView<double> curve(std::size_t k) const {
    CurveView<double> view{form, dimension, degree, curves[k]};
    if (form == Form::rational) view.weights = weights[k];
    return view;
  }
};

/// The rival; `inputs` must outlive it.
Rival kernel_rival(const Kernel<double>& kernel, suite::Mode mode, const Inputs& inputs);

}  // namespace bezierbench::timing
