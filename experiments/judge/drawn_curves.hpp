// SPDX-License-Identifier: MIT
// The first trials of a cell, kept: curves with a parameter each.
#pragma once

#include <cstdint>
#include <vector>

#include "experiments/judge/method_choice.hpp"
#include "experiments/sample/draw.hpp"

namespace bezierbench::judge {

class DrawnCurves {
 public:
  DrawnCurves(const suite::Study& study, const sample::Cell& cell, std::uint64_t seed, std::size_t count)
      : form_(study.curve), cell_(cell), trials_(count) {
    const sample::Sampler sampler(seed, study.id, cell);
    for (std::size_t k = 0; k < count; ++k) sampler.draw(k, trials_[k]);
  }

  [[nodiscard]] std::size_t size() const { return trials_.size(); }
  [[nodiscard]] CurveView<double> curve(std::size_t k) const {
    return {form_, cell_.dimension, cell_.degree, trials_[k].coefficients};
  }
  [[nodiscard]] double t(std::size_t k) const { return trials_[k].t; }
  [[nodiscard]] const sample::Cell& cell() const { return cell_; }

 private:
  Form form_;
  sample::Cell cell_;
  std::vector<sample::Trial> trials_;
};

}  // namespace bezierbench::judge
