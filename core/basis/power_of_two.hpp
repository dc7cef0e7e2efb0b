// SPDX-License-Identifier: MIT
// The powers of two of a floating-point format that fixed-point arithmetic in it needs. Types that are not a
// floating-point format of the processor have functions of the same names of their own, or compute exactly.
#pragma once

#include <bit>
#include <cmath>
#include <concepts>
#include <cstdint>
#include <limits>
#include <type_traits>

namespace bezierbench {

/// The least normal power of two that is not below x, for 0 <= x <= 2^1022 (the largest number over 4, rounded up). In
/// exact arithmetic, which has no places to count, x itself.
template <class Scalar>
Scalar power_of_two_from(const Scalar& x) {
  if constexpr (std::floating_point<Scalar>) {
    if (x <= std::numeric_limits<Scalar>::min()) return std::numeric_limits<Scalar>::min();
    using Bits = std::conditional_t<sizeof(Scalar) == sizeof(std::uint64_t), std::uint64_t, std::uint32_t>;
    constexpr Bits fraction = (Bits(1) << (std::numeric_limits<Scalar>::digits - 1)) - 1;
    return std::bit_cast<Scalar>((std::bit_cast<Bits>(x) + fraction) & ~fraction);  // frexp would be a call
  } else {
    return x;
  }
}

/// The distance of a normal power of two from the next larger number; 0 in exact arithmetic.
template <class Scalar>
Scalar last_place_of(const Scalar& power) {
  if constexpr (std::floating_point<Scalar>)
    return power * std::numeric_limits<Scalar>::epsilon();
  else
    return Scalar(0);
}

/// True where a magnitude is so large that a difference of two such numbers may exceed 2^1022.
template <class Scalar>
bool is_near_overflow(const Scalar& magnitude) {
  if constexpr (std::floating_point<Scalar>)
    return magnitude > std::ldexp(Scalar(1), std::numeric_limits<Scalar>::max_exponent - 3);
  else
    return false;
}

}  // namespace bezierbench
