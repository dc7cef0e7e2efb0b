// SPDX-License-Identifier: MIT
// ends_exact: p(0) = b_0 and p(1) = b_n for all finite control points, subnormal ones included, as values: -0 equals 0.
// Where an operation overflows, so that the result is not finite, the statement says nothing; see finite.hpp.
#pragma once

#include "experiments/guarantees/case.hpp"
#include "experiments/guarantees/excess.hpp"

namespace bezierbench::guarantees {

template <class Scalar>
struct EndsExact {
  static constexpr Property property = Property::ends_exact;

  /// At the end that t is nearer to.
  static void fit(Case<Scalar>& input) { input.t = input.t + input.t <= 1 ? Scalar(0) : Scalar(1); }

  static Excess excess(Evaluation<Scalar>& method, const Case<Scalar>& input) {
    if (input.t != 0 && input.t != 1) return std::nullopt;
    Values<Scalar> end{};
    for (int axis = 0; axis < input.dimension; ++axis)
      end[static_cast<std::size_t>(axis)] = input(axis, input.t == 0 ? 0 : input.degree());
    return difference(method.point(input.coefficients, input.t), end);
  }
};

}  // namespace bezierbench::guarantees
