// SPDX-License-Identifier: MIT
// reversal: the points b_n, ..., b_0 at 1-t give the same values as b_0, ..., b_n at t, for t in [0,1] whose 1-t is
// exact, and all finite control points, subnormal ones included, wherever both values are finite; -0 equals 0.
#pragma once

#include "experiments/guarantees/case.hpp"
#include "experiments/guarantees/excess.hpp"
#include "experiments/guarantees/parameters.hpp"

namespace bezierbench::guarantees {

template <class Scalar>
struct Reversal {
  static constexpr Property property = Property::reversal;

  /// 1 - fl(1-t) has an exact complement: it is t for t >= 1/2, else within u of it.
  static void fit(Case<Scalar>& input) { input.t = 1 - (1 - into_unit_interval(input.t)); }

  static Excess excess(Evaluation<Scalar>& method, const Case<Scalar>& input) {
    if (!has_exact_complement(input.t)) return std::nullopt;
    auto backwards = input;
    const int n = input.degree();
    for (int i = 0; i <= n; ++i)
      for (int axis = 0; axis < input.dimension; ++axis) backwards(axis, i) = input(axis, n - i);
    return difference(method.point(input.coefficients, input.t), method.point(backwards.coefficients, 1 - input.t));
  }
};

}  // namespace bezierbench::guarantees
