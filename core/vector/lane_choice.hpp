// SPDX-License-Identifier: MIT
// What a formula needs to run on a number or on many lanes of numbers with the same text: choices between values, and
// access to a lane.
// core/vector/vectors.hpp has the same functions for vectors.
#pragma once

#include <bit>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <type_traits>

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

/// The value of a lane; a number is the only lane.
constexpr double lane_of(double value, std::size_t /*lane*/) { return value; }
template <class V>
requires requires { V::axes; }
auto lane_of(const V& value, std::size_t lane) { return value.lane(static_cast<int>(lane)); }

/// `value` in the lanes where `condition` holds, `otherwise(lane)` in the others.
template <class Otherwise>
constexpr double value_or(bool condition, double value, const Otherwise& otherwise) {
  return condition ? value : otherwise(0);
}

/// Whether 0 < t < 1; false for NaN. The bits of positive numbers ascend with them, so that one comparison of integers
/// does for floating point: those of 0, less 1, are the largest integer.
template <class Scalar>
auto inside_unit_interval(const Scalar& t) {
  if constexpr (std::floating_point<Scalar>) {
    using Bits = std::conditional_t<sizeof(Scalar) == sizeof(std::uint64_t), std::uint64_t, std::uint32_t>;
    return std::bit_cast<Bits>(t) - 1 < std::bit_cast<Bits>(Scalar(1)) - 1;
  } else {
    return both(Scalar(0) < t, t < Scalar(1));
  }
}

}  // namespace bezierbench
