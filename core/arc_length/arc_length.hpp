// SPDX-License-Identifier: MIT
// The concept of a method for arc length: `info`, and one function from a hodograph to its length with an error
// estimate.
#pragma once

#include <concepts>
#include <type_traits>

#include "core/arc_length/kernel.hpp"
#include "core/curve.hpp"
#include "core/method.hpp"

namespace bezierbench {

template <int Dimension>
struct RationalHodograph;
/// What a method of this form gets of a curve.
template <Form F, int Dimension>
using HodographOf =
    std::conditional_t<F == Form::rational, RationalHodograph<Dimension>, Curve<Form::bernstein, double, Dimension>>;

/// The length of a curve is the integral of |h(t)| over [0, 1], where h is its first hodograph. ArcLengthKernel scales
/// h such that the size of its largest control vector is between 1/2 and 2 sqrt(3). `tolerance` > 0 is relative to the
/// length. If a method cannot keep it, `converged` is false.
///
/// A method of rational form gets U and W of core/arc_length/rational_hodograph.hpp, each scaled so, and |U| / W^2 is
/// the speed.
template <class M>
concept ArcLengthMethod = requires(const HodographOf<M::info.form, 2>& hodograph, double tolerance) {
  requires M::info.problem == Problem::arc_length;
  { M::measure(hodograph, tolerance) } -> std::same_as<ArcLength>;
};

}  // namespace bezierbench
