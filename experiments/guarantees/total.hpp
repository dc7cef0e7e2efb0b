// SPDX-License-Identifier: MIT
// total: p(t) is finite for every finite t outside [0,1] and all control points with (4 (1 + |t|))^n max(1, |b_i|) at
// most 1/4 of the range, which is decided by the exponents of the factors.
#pragma once

#include "experiments/guarantees/case.hpp"
#include "experiments/guarantees/excess.hpp"
#include "experiments/guarantees/parameters.hpp"

namespace bezierbench::guarantees {

template <class Scalar>
struct Total {
  static constexpr Property property = Property::total;

  /// From [0,1] to the left, or from (1/2,1] to the right.
  static void fit(Case<Scalar>& input) {
    if (!in_unit_interval(input.t)) return;
    if (input.t + input.t > 1)
      input.t = 1 + input.t;
    else
      input.t = input.t == 0 ? Scalar(-1) : -input.t;
  }

  static Excess excess(Evaluation<Scalar>& method, const Case<Scalar>& input) {
    if (in_unit_interval(input.t) || !in_range(input)) return std::nullopt;
    if (!all_finite(method.point(input.coefficients, input.t))) return infinite;
    return 0;
  }

 private:
  static bool in_range(const Case<Scalar>& input) {
    int of_t = 0;
    std::frexp(input.t, &of_t);
    int of_points = 0;
    for (const Scalar value : input.coefficients) {
      int exponent = 0;
      std::frexp(value, &exponent);
      of_points = std::max(of_points, exponent);
    }
    const int of_factor = std::max(of_t, 0) + 3;  // 4 (1 + |t|) < 2^of_factor
    return of_points + 2 + input.degree() * of_factor <= std::numeric_limits<Scalar>::max_exponent;
  }
};

}  // namespace bezierbench::guarantees
