// SPDX-License-Identifier: MIT
#pragma once

#include <bit>
#include <concepts>
#include <cstdint>
#include <type_traits>

#include "core/basis/lane_choice.hpp"

namespace bezierbench {

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
