// SPDX-License-Identifier: MIT
// Values that depend on t and the degree only. Where a scalar stands for all axes of a point, they are one number for
// all axes: one division instead of one for each, and comparisons whose results are plain truth values.
#pragma once

namespace bezierbench {

/// t, as the type in which what depends on t alone is computed: `Scalar` itself, unless there is an overload for it, as
/// for Axes (core/evaluate/points/axes.hpp). A Scalar can be constructed from it.
template <class Scalar>
constexpr Scalar parameter_of(const Scalar& t) {
  return t;
}

}  // namespace bezierbench
