// SPDX-License-Identifier: MIT
// The concept of a method for inverse arc length: `info`, and one function from a length to a parameter.
#pragma once

#include <concepts>

#include "core/arc_length/inverse/result.hpp"
#include "core/curve.hpp"
#include "core/method.hpp"

namespace bezierbench {

/// With s(t) the integral of |h| over [0, t], h the hodograph of a curve: t in [0, 1] with s(t) = `target`, where
/// |s(t) - target| <= tolerance s(1). A method is handed a hodograph that is not 0 and is scaled as in ArcLengthMethod,
/// and a finite `target`; one below 0 or above s(1), as a rounded s(1) may be, has its nearest end as the answer. The
/// tolerance is one of the length, not of t: where the speed is 0, the error of t has no bound in terms of that of the
/// length.
template <class M>
concept InverseArcLengthMethod = requires(const Curve<Form::bernstein, double, 2>& hodograph, double target,
                                          double tolerance) {
  requires M::info.problem == Problem::inverse_arc_length;
  { M::solve(hodograph, target, tolerance) } -> std::same_as<InverseArcLength>;
};

}  // namespace bezierbench
