// SPDX-License-Identifier: MIT
// Integer powers of numbers; products with powers of two, and binary exponents.
//
// Exponents and powers of two come from the bits of a number wherever these suffice, since std::ldexp and std::frexp
// are calls of libm. Scalars that are not a floating-point format of the processor compute exactly, or have functions
// of these names of their own.
#pragma once

#include <bit>
#include <cmath>
#include <concepts>
#include <cstdint>
#include <limits>
#include <type_traits>

namespace bezierbench {

/// base^exponent for exponent >= 0 by repeated squaring: `product(a, b)` multiplies, and `one` is its neutral element.
template <class Number, class Product>
constexpr Number power_by_squaring(Number base, int exponent, const Number& one, const Product& product) {
  Number result = one;
  while (true) {
    if (exponent % 2 != 0) result = product(result, base);
    exponent /= 2;
    if (exponent == 0) return result;
    base = product(base, base);
  }
}

/// base^exponent for exponent >= 0: at most exponent - 1 roundings in all.
template <class Scalar>
constexpr Scalar integer_power(Scalar base, int exponent) {
  return power_by_squaring(base, exponent, Scalar(1), [](const Scalar& a, const Scalar& b) -> Scalar { return a * b; });
}

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

/// value 2^exponent, rounded once: std::ldexp(value, exponent).
inline double times_power_of_two(double value, int exponent) {
  constexpr int bias = std::numeric_limits<double>::max_exponent - 1;
  constexpr int digits = std::numeric_limits<double>::digits - 1;
  if (exponent <= -bias || exponent > bias) return std::ldexp(value, exponent);
  return value * std::bit_cast<double>(static_cast<std::uint64_t>(exponent + bias) << digits);
}

/// The exponent e with 2^(e-1) <= |value| < 2^e, and 0 for 0, as std::frexp has it; value is finite.
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
