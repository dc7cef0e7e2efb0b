// SPDX-License-Identifier: MIT
// Trials of a cell: a curve and a parameter.
#pragma once

#include <cstdint>

#include "experiments/judge/methods.hpp"
#include "experiments/sample/draw.hpp"

namespace bezierbench::judge {

/// Is neither copied nor moved: the curve refers to the trial.
struct DrawnCurve {
  sample::Trial trial;
  CurveView<double> curve;

  DrawnCurve() = default;
  DrawnCurve(const DrawnCurve&) = delete;
  DrawnCurve& operator=(const DrawnCurve&) = delete;
};

class CurveSampler {
 public:
  CurveSampler(const suite::Study& study, std::uint64_t seed, const sample::Cell& cell)
      : form_(study.form), cell_(cell), sampler_(seed, study.id, cell) {}

  void draw(std::uint64_t number, DrawnCurve& drawn) const {
    sampler_.draw(number, drawn.trial);
    drawn.curve = {form_, cell_.dimension, cell_.degree, drawn.trial.coefficients, drawn.trial.weights};
  }

 private:
  Form form_;
  sample::Cell cell_;
  sample::Sampler sampler_;
};

}  // namespace bezierbench::judge
