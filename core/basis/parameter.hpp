// SPDX-License-Identifier: MIT
// Values that depend on t and the degree only. Where a scalar stands for all axes of a point, they are one number for
// all axes: one division instead of one for each, and comparisons whose results are plain truth values.
#pragma once

namespace bezierbench {

/// Returns t in the type for values that depend on t alone. That type is `Scalar`; for Axes, which have a function of
/// their own in core/evaluate/points/axes.hpp, it is the type of a coordinate. A Scalar can be constructed from either.
template <class Scalar>
constexpr Scalar parameter_of(const Scalar& t) {
  return t;
}

}  // namespace bezierbench
