// SPDX-License-Identifier: MIT
// monotone: b_0 <= ... <= b_n gives p(t) <= p(t') for all t < t' in [0,1], neighbouring numbers included, and
// b_0 >= ... >= b_n gives p(t) >= p(t'); for all finite control points, subnormal ones included, wherever both values
// are finite. A constant sequence is both, so that a method that does not reproduce constants is not monotone.
#pragma once

#include <functional>

#include "experiments/guarantees/case.hpp"
#include "experiments/guarantees/excess.hpp"
#include "experiments/guarantees/parameters.hpp"

namespace bezierbench::guarantees {

template <class Scalar>
struct Monotone {
  static constexpr Property property = Property::monotone;
  static constexpr bool uses_t_next = true;

  /// Sorts every axis, in the order of its two ends, and takes the next number for a t' that is not above t.
  static void fit(Case<Scalar>& input) {
    input.t = into_unit_interval(input.t);
    if (input.t == 1) input.t = std::nextafter(Scalar(1), Scalar(0));
    if (!(input.t_next > input.t && input.t_next <= 1)) input.t_next = std::nextafter(input.t, Scalar(1));
    std::vector<Scalar> sequence(static_cast<std::size_t>(input.degree()) + 1);
    for (int axis = 0; axis < input.dimension; ++axis) {
      for (std::size_t i = 0; i < sequence.size(); ++i) sequence[i] = input(axis, static_cast<int>(i));
      if (sequence.front() <= sequence.back())
        std::ranges::sort(sequence);
      else
        std::ranges::sort(sequence, std::greater());
      for (std::size_t i = 0; i < sequence.size(); ++i) input(axis, static_cast<int>(i)) = sequence[i];
    }
  }

  static Excess excess(Evaluation<Scalar>& method, const Case<Scalar>& input) {
    const auto [at, next] = method.points(input.coefficients, std::array{input.t, input.t_next});
    if (!all_finite(at) || !all_finite(next)) return std::nullopt;
    double largest = -infinite;
    for (int axis = 0; axis < input.dimension; ++axis) {
      const auto a = static_cast<std::size_t>(axis);
      const double fall = ulps_above(at[a], next[a]);
      const Scalar first = input(axis, 0);
      const Scalar last = input(axis, input.degree());
      if (first <= last) largest = std::max(largest, fall);
      if (first >= last) largest = std::max(largest, -fall);
    }
    return largest;
  }
};

}  // namespace bezierbench::guarantees
