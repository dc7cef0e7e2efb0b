// SPDX-License-Identifier: MIT
// The inputs of races whose result is known beforehand: one curve at many t, the same in every run.
#pragma once

#include <cstddef>
#include <vector>

#include "core/evaluate/kernel/prepared_state.hpp"
#include "experiments/race/kernel_rival.hpp"

namespace bezierbench::programs {

/// `points` parameters in (0, 1), in no order; `points` is not a multiple of 5.
template <class Scalar>
race::Inputs<Scalar> one_curve(Form form, int dimension, int degree, std::size_t points) {
  race::Inputs<Scalar> inputs{form, dimension, degree, {}, {}, {}};
  std::vector<Scalar> coefficients;
  for (int k = 0; k < dimension * (degree + 1); ++k) coefficients.push_back(Scalar(k * k % 17 / 17.0 - 0.5));
  inputs.curves.assign(points, coefficients);
  if (form == Form::rational) {
    std::vector<Scalar> weights;
    for (int i = 0; i <= degree; ++i) weights.push_back(Scalar(1 + i % 3 / 4.0));
    inputs.weights.assign(points, weights);
  }
  for (std::size_t k = 0; k < points; ++k)
    inputs.t.push_back((static_cast<Scalar>(k * 5 % points) + Scalar(0.5)) / static_cast<Scalar>(points));
  return inputs;
}

/// The points of the first curve at every t, one after the other.
template <class Scalar>
std::vector<Scalar> points_of(const Kernel<Scalar>& kernel, const race::Inputs<Scalar>& inputs) {
  std::vector<Scalar> points(inputs.t.size() * static_cast<std::size_t>(inputs.dimension));
  PreparedState<Scalar>(kernel, inputs.curve(0)).evaluate(inputs.t, points.data());
  return points;
}

}  // namespace bezierbench::programs
