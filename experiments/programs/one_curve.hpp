// SPDX-License-Identifier: MIT
// The inputs of races whose result is known beforehand: one curve of the plane at many t, the same in every run.
#pragma once

#include <cstddef>
#include <vector>

#include "core/evaluate/prepared_state.hpp"
#include "experiments/race/kernel_rival.hpp"

namespace bezierbench::programs {

/// `points` parameters in (0, 1), in no order; `points` is not a multiple of 5.
inline race::Inputs<double> one_curve(Form form, int degree, std::size_t points) {
  race::Inputs<double> inputs{form, 2, degree, {}, {}, {}};
  std::vector<double> coefficients;
  for (int k = 0; k < 2 * (degree + 1); ++k) coefficients.push_back(k * k % 17 / 17.0 - 0.5);
  inputs.curves.assign(points, coefficients);
  for (std::size_t k = 0; k < points; ++k)
    inputs.t.push_back((static_cast<double>(k * 5 % points) + 0.5) / static_cast<double>(points));
  return inputs;
}

/// The points of the first curve at every t, one after the other.
inline std::vector<double> points_of(const Kernel<double>& kernel, const race::Inputs<double>& inputs) {
  std::vector<double> points(inputs.t.size() * 2);
  PreparedState<double>(kernel, inputs.curve(0)).evaluate(inputs.t, points.data());
  return points;
}

}  // namespace bezierbench::programs
