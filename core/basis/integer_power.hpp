// SPDX-License-Identifier: MIT
#pragma once

namespace bezierbench {

/// base^exponent for exponent >= 0 by repeated squaring: at most exponent - 1 roundings in all.
template <class Scalar>
constexpr Scalar integer_power(Scalar base, int exponent) {
  auto result = Scalar(1);
  while (true) {
    if (exponent % 2 != 0) result *= base;
    exponent /= 2;
    if (exponent == 0) return result;
    base *= base;
  }
}

}  // namespace bezierbench
