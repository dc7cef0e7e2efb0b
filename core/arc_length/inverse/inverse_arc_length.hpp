// SPDX-License-Identifier: MIT
// The concept of a method for inverse arc length: `info`, and one function from a length to a parameter.
#pragma once

#include <concepts>

#include "core/arc_length/arc_length.hpp"
#include "core/arc_length/inverse/kernel.hpp"
#include "core/curve.hpp"
#include "core/method.hpp"

namespace bezierbench {

/// Let s(t) be the integral of |h| over [0, t], h the hodograph of a curve. A method returns t in [0, 1] such that the
/// error |s(t) - target| is at most tolerance s(1). Its hodograph is not 0 and is scaled as for ArcLengthMethod.
/// `target` is finite. A target below 0 gives t = 0, and one above s(1), as a rounded s(1) may be, gives t = 1. The
/// tolerance applies to the length, not to t: where the speed is 0, the error of the length does not bound that of t.
template <class M>
concept InverseArcLengthMethod = requires(const HodographOf<M::info.form, 2>& hodograph, double target,
                                          double tolerance) {
  requires M::info.problem == Problem::inverse_arc_length;
  { M::solve(hodograph, target, tolerance) } -> std::same_as<InverseArcLength>;
};

}  // namespace bezierbench
