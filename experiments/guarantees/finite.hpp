// SPDX-License-Identifier: MIT
// finite: p(t) is finite for t in [0,1] and all finite control points, the largest included. The other statements are
// about values that are finite, so that overflow counts here alone.
#pragma once

#include "experiments/guarantees/case.hpp"
#include "experiments/guarantees/excess.hpp"
#include "experiments/guarantees/parameters.hpp"

namespace bezierbench::guarantees {

template <class Scalar>
struct Finite {
  static constexpr Property property = Property::finite;

  static void fit(Case<Scalar>& input) { input.t = into_unit_interval(input.t); }

  /// Minus the share of the range that is left above the largest coordinate.
  static Excess excess(Evaluation<Scalar>& method, const Case<Scalar>& input) {
    const auto point = method.point(input.coefficients, input.t);
    if (!all_finite(point)) return infinite;
    Scalar largest = 0;
    for (const Scalar value : point) largest = std::max(largest, std::abs(value));
    return static_cast<double>(largest) / static_cast<double>(std::numeric_limits<Scalar>::max()) - 1;
  }
};

}  // namespace bezierbench::guarantees
