// SPDX-License-Identifier: MIT
// in_hull: min_i b_i <= p(t) <= max_i b_i on every axis for t in [0,1] and all finite control points, subnormal ones
// included, wherever the result is finite.
#pragma once

#include "experiments/guarantees/case.hpp"
#include "experiments/guarantees/excess.hpp"
#include "experiments/guarantees/parameters.hpp"

namespace bezierbench::guarantees {

template <class Scalar>
struct InHull {
  static constexpr Property property = Property::in_hull;

  static void fit(Case<Scalar>& input) { input.t = into_unit_interval(input.t); }

  static Excess excess(Evaluation<Scalar>& method, const Case<Scalar>& input) {
    const auto point = method.point(input.coefficients, input.t);
    if (!all_finite(point)) return std::nullopt;
    double largest = -infinite;
    for (int axis = 0; axis < input.dimension; ++axis) {
      Scalar low = input(axis, 0);
      Scalar high = low;
      for (int i = 1; i <= input.degree(); ++i) {
        low = std::min(low, input(axis, i));
        high = std::max(high, input(axis, i));
      }
      const Scalar value = point[static_cast<std::size_t>(axis)];
      largest = std::max({largest, ulps_above(value, high), ulps_above(low, value)});
    }
    return largest;
  }
};

}  // namespace bezierbench::guarantees
