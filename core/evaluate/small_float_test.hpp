// SPDX-License-Identifier: MIT
// A binary floating-point format of few bits, emulated, with so few numbers that a test can go through all of them.
#pragma once

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

#include "core/error_free.hpp"

namespace bezierbench {

/// Numbers with `Precision` bits and exponents LowestExponent .. HighestExponent of the leading bit, subnormal ones,
/// the infinities and NaN, as IEEE 754 has them: every operation rounds once, to nearest, ties to even.
/// SmallFloat<11, -14, 15> is binary16. The exact results fit into a double, or into its sum and error.
template <int Precision, int LowestExponent, int HighestExponent>
class SmallFloat {
 public:
  SmallFloat() = default;
  explicit SmallFloat(double value) : value_(rounded(value, 0)) {}

  [[nodiscard]] double value() const { return value_; }

  friend SmallFloat operator+(SmallFloat a, SmallFloat b) { return sum(a.value_, b.value_); }
  friend SmallFloat operator-(SmallFloat a, SmallFloat b) { return sum(a.value_, -b.value_); }
  friend SmallFloat operator*(SmallFloat a, SmallFloat b) { return SmallFloat(a.value_ * b.value_); }
  friend SmallFloat operator-(SmallFloat a) { return SmallFloat(-a.value_); }
  friend SmallFloat operator/(SmallFloat a, SmallFloat power_of_two) {
    return SmallFloat(a.value_ / power_of_two.value_);
  }
  friend SmallFloat abs(SmallFloat a) { return SmallFloat(std::abs(a.value_)); }
  SmallFloat& operator+=(SmallFloat b) { return *this = *this + b; }
  SmallFloat& operator*=(SmallFloat b) { return *this = *this * b; }
  /// *this b + c, rounded once.
  [[nodiscard]] SmallFloat fused(const SmallFloat& b, const SmallFloat& c) const {
    return sum(value_ * b.value_, c.value_);
  }
  friend bool operator==(SmallFloat a, SmallFloat b) { return a.value_ == b.value_; }
  friend auto operator<=>(SmallFloat a, SmallFloat b) { return a.value_ <=> b.value_; }

  /// As core/powers.hpp has them for double.
  friend SmallFloat power_of_two_from(SmallFloat x) {
    const double least = std::ldexp(1.0, LowestExponent);
    if (x.value_ <= least) return SmallFloat(least);
    const double below = std::ldexp(1.0, std::ilogb(x.value_));
    return SmallFloat(below == x.value_ ? below : 2 * below);
  }
  friend SmallFloat last_place_of(SmallFloat power) { return SmallFloat(spacing(power.value_)); }
  friend bool is_near_overflow(SmallFloat magnitude) { return magnitude.value_ > std::ldexp(1.0, HighestExponent - 2); }

  /// All finite numbers in ascending order; 0 once.
  static std::vector<SmallFloat> all() {
    std::vector<SmallFloat> numbers;
    const double largest = std::ldexp(2 - std::ldexp(2.0, -Precision), HighestExponent);
    for (double value = 0; value <= largest; value += spacing(value)) {
      numbers.push_back(SmallFloat(value));
      if (value > 0) numbers.push_back(SmallFloat(-value));
    }
    std::ranges::sort(numbers);
    return numbers;
  }

 private:
  static double spacing(double value) {
    constexpr double least = power_of_two(LowestExponent);
    constexpr std::uint64_t exponent_bits = 0x7ff0000000000000;
    const double power = std::bit_cast<double>(std::bit_cast<std::uint64_t>(value) & exponent_bits);
    return std::max(least, power) * power_of_two(1 - Precision);
  }
  static constexpr double power_of_two(int exponent) {
    return std::bit_cast<double>(static_cast<std::uint64_t>(1023 + exponent) << 52);
  }
  static SmallFloat sum(double a, double b) {
    const auto exact = two_sum(a, b);
    SmallFloat result;
    result.value_ = rounded(exact.value, exact.error);
    return result;
  }
  /// value + error, where the error is far below the last place of the format at the value.
  static double rounded(double value, double error) {
    if (!std::isfinite(value) || value == 0) return value;
    const double unit = spacing(value);
    const double far = 0x1.8p+52 * unit;  // where the last place is one unit
    double result = (value + far) - far;
    if (std::abs(value - result) == unit / 2 && error != 0 && std::isfinite(error))  // a tie without the error
      result = value + std::copysign(unit / 2, error);
    if (std::abs(result) >= power_of_two(HighestExponent + 1)) result = std::numeric_limits<double>::infinity();
    return std::copysign(result, value);
  }

  double value_ = 0;
};

}  // namespace bezierbench
