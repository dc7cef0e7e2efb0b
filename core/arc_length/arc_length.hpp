// SPDX-License-Identifier: MIT
// The concept of a method for arc length: `info`, and one function from a hodograph to a length with its error.
#pragma once

#include <concepts>

#include "core/arc_length/result.hpp"
#include "core/curve.hpp"
#include "core/method.hpp"

namespace bezierbench {

/// The length of a curve is the integral of |h(t)| over [0, 1], h its first hodograph, which a method is handed scaled
/// such that the largest of its control vectors has a size between 1/2 and 2 sqrt(3) (ArcLengthKernel does that).
/// `tolerance` > 0 is relative to the length. A method that cannot keep it says so: `converged` is then false.
template <class M>
concept ArcLengthMethod = requires(const Curve<Form::bernstein, double, 2>& hodograph, double tolerance) {
  requires M::info.problem == Problem::arc_length;
  { M::measure(hodograph, tolerance) } -> std::same_as<ArcLength>;
};

}  // namespace bezierbench
