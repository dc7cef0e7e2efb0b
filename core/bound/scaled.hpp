// SPDX-License-Identifier: MIT
// A number >= 0 with the precision of double and an exponent that neither overflows nor underflows.
#pragma once

#include <cmath>

namespace bezierbench {

class Scaled {
 public:
  /// Takes a value >= 0, which may be infinite.
  explicit Scaled(double value) { set(value, 0); }

  friend Scaled operator*(Scaled a, Scaled b) {
    if (a.mantissa_ == 0 || b.mantissa_ == 0) return Scaled(0);
    return {a.mantissa_ * b.mantissa_, a.exponent_ + b.exponent_};
  }
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
    if (std::isinf(value)) shift = beyond_all;
    exponent_ = value == 0 ? 0 : exponent + shift;
  }

  static constexpr int beyond_all = 1 << 30;  ///< the exponent of infinity, so that no sum drops it

  double mantissa_ = 0;  ///< in [1/2, 1), or 0, or infinite
  long exponent_ = 0;
};

}  // namespace bezierbench
