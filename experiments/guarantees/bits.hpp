// SPDX-License-Identifier: MIT
// The bits that a number takes.
#pragma once

#include <bit>
#include <cmath>
#include <cstdint>

namespace bezierbench::guarantees {

/// The exponent of the lowest bit that is set, for x != 0.
inline int lowest_bit(double x) {
  int exponent = 0;
  const auto integer = static_cast<std::uint64_t>(std::ldexp(std::abs(std::frexp(x, &exponent)), 53));
  return exponent - 53 + std::countr_zero(integer);
}

/// The bits from the highest to the lowest that is set; 0 for 0.
inline int significant_bits(double x) { return x == 0 ? 0 : std::ilogb(x) - lowest_bit(x) + 1; }

}  // namespace bezierbench::guarantees
