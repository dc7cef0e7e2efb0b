// SPDX-License-Identifier: MIT
// A positive number with the precision of double and an exponent that neither overflows nor underflows.
#pragma once

#include <cmath>

namespace bezierbench {

class Scaled {
 public:
  /// Takes a finite value >= 0.
  explicit Scaled(double value) { set(value, 0); }

  friend Scaled operator*(Scaled a, Scaled b) { return {a.mantissa_ * b.mantissa_, a.exponent_ + b.exponent_}; }
  friend Scaled operator+(Scaled a, Scaled b) {
    if (a.mantissa_ == 0) return b;
    if (b.mantissa_ == 0) return a;
    if (a.exponent_ < b.exponent_) return b + a;
    constexpr long negligible = 200;  // bits: far beyond the precision of the sum
    if (a.exponent_ - b.exponent_ > negligible) return a;
    return {a.mantissa_ + std::ldexp(b.mantissa_, static_cast<int>(b.exponent_ - a.exponent_)), a.exponent_};
  }

  /// The value rounded to double: 0 or infinity where it leaves the range.
  [[nodiscard]] double to_double() const {
    constexpr long beyond = 5000;
    if (exponent_ > beyond || exponent_ < -beyond) return exponent_ > 0 ? std::ldexp(mantissa_, 2000) : 0;
    return std::ldexp(mantissa_, static_cast<int>(exponent_));
  }

 private:
  Scaled(double mantissa, long exponent) { set(mantissa, exponent); }
  void set(double value, long exponent) {
    int shift = 0;
    mantissa_ = std::frexp(value, &shift);
    exponent_ = value == 0 ? 0 : exponent + shift;
  }

  double mantissa_ = 0;  ///< in [1/2, 1), or 0
  long exponent_ = 0;
};

}  // namespace bezierbench
