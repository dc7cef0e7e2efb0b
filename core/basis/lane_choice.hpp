// SPDX-License-Identifier: MIT
// What a formula needs to run on a double or on many lanes of doubles with the same text: choices between values, and
// access to a lane. core/batch/lanes.hpp has the same functions for lanes.
#pragma once

#include <cstddef>

namespace bezierbench {

/// `first` where `condition` holds, else `second`.
template <class Scalar>
constexpr Scalar select(bool condition, const Scalar& first, const Scalar& second) {
  return condition ? first : second;
}

constexpr bool both(bool a, bool b) { return a && b; }
constexpr bool either(bool a, bool b) { return a || b; }
/// True where a choice is the first one in all lanes.
constexpr bool all_of(bool condition) { return condition; }
/// True where a choice is the first one in some lane.
constexpr bool any_of(bool condition) { return condition; }

/// The value of a lane; a scalar is the only lane.
constexpr double lane_of(double value, std::size_t /*lane*/) { return value; }

/// `value` in the lanes where `condition` holds, `otherwise(lane)` in the others.
template <class Otherwise>
constexpr double value_or(bool condition, double value, const Otherwise& otherwise) {
  return condition ? value : otherwise(0);
}

}  // namespace bezierbench
