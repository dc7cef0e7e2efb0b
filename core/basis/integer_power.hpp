// SPDX-License-Identifier: MIT
#pragma once

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

}  // namespace bezierbench
