// SPDX-License-Identifier: MIT
// constant_reproduced: where all b_i are the same point c, p(t) = c for t in [0,1], for every finite c, subnormal ones
// included, wherever the result is finite.
#pragma once

#include "experiments/guarantees/case.hpp"
#include "experiments/guarantees/excess.hpp"
#include "experiments/guarantees/parameters.hpp"

namespace bezierbench::guarantees {

template <class Scalar>
struct ConstantReproduced {
  static constexpr Property property = Property::constant_reproduced;

  static void fit(Case<Scalar>& input) {
    input.t = into_unit_interval(input.t);
    for (int i = 1; i <= input.degree(); ++i)
      for (int axis = 0; axis < input.dimension; ++axis) input(axis, i) = input(axis, 0);
  }

  static Excess excess(Evaluation<Scalar>& method, const Case<Scalar>& input) {
    Values<Scalar> constant{};
    for (int axis = 0; axis < input.dimension; ++axis) constant[static_cast<std::size_t>(axis)] = input(axis, 0);
    return difference(method.point(input.coefficients, input.t), constant);
  }
};

}  // namespace bezierbench::guarantees
