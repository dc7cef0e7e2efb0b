// SPDX-License-Identifier: MIT
// A real number as a pair of doubles, with the operators that true lengths are computed with.
//
// In units of u^2 = 2^-106 a product is off by at most 8 of itself, a quotient by 16, a square root by 6, and a sum by
// 4 of the sum of the sizes of its terms (pair.hpp). Numbers must stay away from overflow, and sums of interest from
// 2^-900.
#pragma once

#include <cmath>
#include <compare>
#include <concepts>

#include "reference/pair.hpp"

namespace bezierbench::reference {

class PairReal {
 public:
  PairReal() = default;
  template <std::floating_point Number>
  PairReal(Number value) : pair_{value, 0} {}  // NOLINT(google-explicit-constructor): as the numbers of Boost
  /// Of at most 53 bits.
  template <std::integral Number>
  PairReal(Number value) : pair_{static_cast<double>(value), 0} {}  // NOLINT(google-explicit-constructor)
  explicit PairReal(Pair pair) : pair_(pair) {}

  [[nodiscard]] const Pair& pair() const { return pair_; }
  /// The double nearest to it.
  template <std::same_as<double> Number>
  [[nodiscard]] Number convert_to() const {
    return pair_.high;
  }

  friend PairReal operator-(const PairReal& x) { return PairReal(Pair{-x.pair_.high, -x.pair_.low}); }
  friend PairReal operator+(const PairReal& x, const PairReal& y) { return PairReal(sum(x.pair_, y.pair_)); }
  friend PairReal operator-(const PairReal& x, const PairReal& y) { return x + -y; }
  friend PairReal operator*(const PairReal& x, const PairReal& y) { return PairReal(product(x.pair_, y.pair_)); }
  friend PairReal operator/(const PairReal& x, const PairReal& y) { return PairReal(quotient(x.pair_, y.pair_)); }
  PairReal& operator+=(const PairReal& y) { return *this = *this + y; }
  PairReal& operator-=(const PairReal& y) { return *this = *this - y; }
  PairReal& operator*=(const PairReal& y) { return *this = *this * y; }

  friend bool operator==(const PairReal& x, const PairReal& y) {
    return x.pair_.high == y.pair_.high && x.pair_.low == y.pair_.low;
  }
  friend std::partial_ordering operator<=>(const PairReal& x, const PairReal& y) {
    return x.pair_.high == y.pair_.high ? x.pair_.low <=> y.pair_.low : x.pair_.high <=> y.pair_.high;
  }

  friend PairReal abs(const PairReal& x) { return x.pair_.high < 0 ? -x : x; }

  friend PairReal sqrt(const PairReal& x) {
    if (x.pair_.high <= 0) return 0;
    const double root = std::sqrt(x.pair_.high);
    const double rest = fused(-root, root, x.pair_.high) + x.pair_.low;
    return PairReal(pair_of(fast_two_sum(root, rest / (2 * root))));
  }

 private:
  Pair pair_;
};

}  // namespace bezierbench::reference
