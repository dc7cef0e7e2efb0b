// SPDX-License-Identifier: MIT
// translation: for c such that all b_i + c are exact, the points b_i + c give p(t) + c, rounded once, for t in [0,1],
// wherever these values are finite. c is added on the first axis. As p(t) itself is rounded, even correct rounding does
// not keep this; what a search finds is the largest difference.
#pragma once

#include "core/error_free.hpp"
#include "experiments/guarantees/case.hpp"
#include "experiments/guarantees/excess.hpp"
#include "experiments/guarantees/parameters.hpp"

namespace bezierbench::guarantees {

template <class Scalar>
struct Translation {
  static constexpr Property property = Property::translation;
  static constexpr bool uses_offset = true;

  /// Takes from each b_i what is lost when c is added; for two in three inputs all sums are exact then.
  static void fit(Case<Scalar>& input) {
    input.t = into_unit_interval(input.t);
    for (int i = 0; i <= input.degree(); ++i) {
      const Scalar kept = (input(0, i) + input.offset) - input.offset;
      if (std::isfinite(kept)) input(0, i) = kept;
    }
  }

  static Excess excess(Evaluation<Scalar>& method, const Case<Scalar>& input) {
    auto moved = input;
    for (int i = 0; i <= input.degree(); ++i) {
      const auto sum = two_sum(input(0, i), input.offset);
      if (!(sum.error == 0) || !std::isfinite(sum.value)) return std::nullopt;
      moved(0, i) = sum.value;
    }
    auto expected = method.point(input.coefficients, input.t);
    expected[0] += input.offset;
    return difference(method.point(moved.coefficients, input.t), expected);
  }
};

}  // namespace bezierbench::guarantees
