// SPDX-License-Identifier: MIT
// Products with powers of two and binary exponents. The results are those of std::ldexp and std::frexp, which are calls
// of libm; here they come from the bits of a double wherever these suffice.
#pragma once

#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

namespace bezierbench {

/// value 2^exponent, rounded once: std::ldexp(value, exponent).
inline double times_power_of_two(double value, int exponent) {
  constexpr int bias = std::numeric_limits<double>::max_exponent - 1;
  constexpr int digits = std::numeric_limits<double>::digits - 1;
  if (exponent <= -bias || exponent > bias) return std::ldexp(value, exponent);
  return value * std::bit_cast<double>(static_cast<std::uint64_t>(exponent + bias) << digits);
}

/// The exponent e with 2^(e-1) <= |value| < 2^e, as std::frexp has it; value is finite and not 0.
inline int binary_exponent(double value) {
  constexpr int bias = std::numeric_limits<double>::max_exponent - 1;
  constexpr int digits = std::numeric_limits<double>::digits - 1;
  if (std::abs(value) >= std::numeric_limits<double>::min())
    return static_cast<int>((std::bit_cast<std::uint64_t>(value) << 1) >> (digits + 1)) - bias + 1;
  int exponent = 0;
  std::frexp(value, &exponent);
  return exponent;
}

}  // namespace bezierbench
