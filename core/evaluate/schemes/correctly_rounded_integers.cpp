// SPDX-License-Identifier: MIT
#include "core/evaluate/schemes/correctly_rounded_integers.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <utility>

#include "core/split_double.hpp"

namespace bezierbench {
namespace {

using Limb = std::uint64_t;
__extension__ using Wide = unsigned __int128;
constexpr int limb_bits = 64;
constexpr int significand_bits = 53;
constexpr int coefficient_bits = 2098;  // from 2^-1074 to below 2^1024
constexpr int parameter_bits = 1074;    // e for the smallest subnormal t

/// Limbs for a number below 2^bits in magnitude and its sign.
constexpr int limbs(int bits) { return bits / limb_bits + 1; }

/// (-1)^negative magnitude 2^exponent with an odd magnitude, or zero.
struct Dyadic {
  explicit Dyadic(double value) : negative(std::signbit(value)) {
    if (value == 0) return;
    const auto split = split_double(std::abs(value));
    const int zeros = std::countr_zero(static_cast<Limb>(split.significand));
    magnitude = static_cast<Limb>(split.significand) >> zeros;
    exponent = split.exponent + zeros;
  }
  [[nodiscard]] int top() const { return exponent + static_cast<int>(std::bit_width(magnitude)); }

  bool negative;
  Limb magnitude = 0;
  int exponent = 0;
};

/// C(n,k) T^k, from one k to the next.
class WeightedPower {
 public:
  WeightedPower(int degree, Limb base) : degree_(degree), base_(base) { limb_[0] = 1; }

  /// base < 2^53 and n < 2^10, so that each factor is one limb; the quotient is an integer.
  void advance() {
    ++k_;
    multiply(base_ * static_cast<Limb>(degree_ - k_ + 1));
    divide_exactly(static_cast<Limb>(k_));
    while (size_ > 1 && limb_[size_ - 1] == 0) --size_;
  }
  [[nodiscard]] const Limb* data() const { return limb_.data(); }
  [[nodiscard]] std::size_t size() const { return size_; }

 private:
  static constexpr std::size_t room = limbs((significand_bits + 2) * rounded_max_degree) + 1;

  void multiply(Limb factor) {
    Limb carry = 0;
    for (std::size_t j = 0; j < size_; ++j) {
      const Wide product = Wide(limb_[j]) * factor + carry;
      limb_[j] = static_cast<Limb>(product);
      carry = static_cast<Limb>(product >> limb_bits);
    }
    limb_[size_++] = carry;
  }

  /// From the lowest limb on, by the inverse of the odd part of the divisor modulo 2^64: [Jebelean 1993].
  void divide_exactly(Limb divisor) {
    const int zeros = std::countr_zero(divisor);
    const Limb odd = divisor >> zeros;
    Limb inverse = odd;  // right in its last 3 bits; each step doubles them
    for (int bits = 3; bits < limb_bits; bits *= 2) inverse *= 2 - odd * inverse;
    Limb borrow = 0;
    for (std::size_t j = 0; j < size_; ++j) {
      const Limb above = j + 1 < size_ ? limb_[j + 1] : 0;
      const Limb dividend = zeros == 0 ? limb_[j] : (limb_[j] >> zeros) | (above << (limb_bits - zeros));
      const Limb quotient = (dividend - borrow) * inverse;
      borrow = static_cast<Limb>((Wide(quotient) * odd) >> limb_bits) + (dividend < borrow ? 1 : 0);
      limb_[j] = quotient;
    }
  }

  int degree_;
  Limb base_;
  int k_ = 0;
  std::size_t size_ = 1;
  std::array<Limb, room> limb_;
};

/// An integer in two's complement.
class Integer {
 public:
  void set_zero(int size) {
    size_ = static_cast<std::size_t>(size);
    std::fill_n(limb_.begin(), size_, 0);
  }

  /// a (2^shift - factor), which must fit into `size` limbs.
  void set_difference(const Integer& a, int shift, Limb factor, int size) {
    const auto whole = static_cast<std::size_t>(shift / limb_bits);
    const int part = shift % limb_bits;
    size_ = static_cast<std::size_t>(size);
    const Limb sign = a.extension();
    Limb carry = 0;   // of a factor
    Limb borrow = 0;  // of the difference
    Limb below = 0;   // the limb of a under the one that is shifted
    for (std::size_t j = 0; j < size_; ++j) {
      const Wide product = Wide(a.limb(j, sign)) * factor + carry;
      carry = static_cast<Limb>(product >> limb_bits);
      const Limb here = j < whole ? 0 : a.limb(j - whole, sign);
      const Limb shifted = part == 0 ? here : (here << part) | (below >> (limb_bits - part));
      below = here;
      const Wide difference = Wide(shifted) - static_cast<Limb>(product) - borrow;
      limb_[j] = static_cast<Limb>(difference);
      borrow = static_cast<Limb>(difference >> limb_bits) & 1;
    }
  }

  /// a factor, which must fit into `size` limbs.
  void set_product(const Integer& a, Limb factor, int size) {
    size_ = static_cast<std::size_t>(size);
    const Limb sign = a.extension();
    Limb carry = 0;
    for (std::size_t j = 0; j < size_; ++j) {
      const Wide product = Wide(a.limb(j, sign)) * factor + carry;
      limb_[j] = static_cast<Limb>(product);
      carry = static_cast<Limb>(product >> limb_bits);
    }
  }

  /// Adds (-1)^negative times the natural number in `count` limbs times factor 2^shift.
  void add(const Limb* natural, std::size_t count, Limb factor, bool negative, int shift) {
    const auto whole = static_cast<std::size_t>(shift / limb_bits);
    const int part = shift % limb_bits;
    Limb product_carry = 0;
    Limb below = 0;
    Limb carry = 0;
    for (std::size_t k = 0; whole + k < size_; ++k) {
      const Wide product = (k < count ? Wide(natural[k]) * factor : Wide(0)) + product_carry;
      const auto here = static_cast<Limb>(product);
      product_carry = static_cast<Limb>(product >> limb_bits);
      const Limb term = part == 0 ? here : (here << part) | (below >> (limb_bits - part));
      below = here;
      Limb& limb = limb_[whole + k];
      const Wide sum = negative ? Wide(limb) - term - carry : Wide(limb) + term + carry;
      limb = static_cast<Limb>(sum);
      carry = static_cast<Limb>(sum >> limb_bits) & 1;
      if (k > count + 1 && carry == 0) break;  // nothing is left to add
    }
  }

  /// The number of Scalar nearest to this times 2^exponent, ties to even. Leaves the magnitude.
  template <class Scalar>
  Scalar rounded(long exponent) {
    using Limits = std::numeric_limits<Scalar>;
    const bool negative = extension() != 0;
    if (negative) negate();
    while (size_ > 0 && limb_[size_ - 1] == 0) --size_;
    if (size_ == 0) return 0;
    const long top = static_cast<long>(size_) * limb_bits - 1 - std::countl_zero(limb_[size_ - 1]);
    const long smallest = Limits::min_exponent - Limits::digits;  // of the smallest subnormal
    const long lowest = std::max(top + exponent - (Limits::digits - 1), smallest);
    const long dropped = lowest - exponent;
    Limb kept = bits_from(dropped);
    if (dropped > 0 && bit(dropped - 1) && ((kept & 1) != 0 || any_below(dropped - 1))) ++kept;
    const Scalar magnitude = std::ldexp(static_cast<Scalar>(kept), static_cast<int>(std::max(lowest, exponent)));
    return negative ? -magnitude : magnitude;
  }

 private:
  static constexpr std::size_t room = limbs(rounded_max_degree * (parameter_bits + 1) + coefficient_bits + limb_bits);

  [[nodiscard]] Limb extension() const { return (limb_[size_ - 1] >> (limb_bits - 1)) == 0 ? 0 : ~Limb(0); }
  [[nodiscard]] Limb limb(std::size_t j, Limb sign) const { return j < size_ ? limb_[j] : sign; }

  void negate() {
    Limb carry = 1;
    for (std::size_t j = 0; j < size_; ++j) {
      limb_[j] = ~limb_[j] + carry;
      carry = carry != 0 && limb_[j] == 0 ? 1 : 0;
    }
  }

  /// This number without its last `dropped` bits, which leaves at most 64; all of it where there are none to drop.
  [[nodiscard]] Limb bits_from(long dropped) const {
    if (dropped <= 0) return limb_[0];
    const auto whole = static_cast<std::size_t>(dropped / limb_bits);
    const int part = static_cast<int>(dropped % limb_bits);
    if (whole >= size_) return 0;
    const Limb above = whole + 1 < size_ ? limb_[whole + 1] : 0;
    return part == 0 ? limb_[whole] : (limb_[whole] >> part) | (above << (limb_bits - part));
  }

  [[nodiscard]] bool bit(long place) const {
    const auto whole = static_cast<std::size_t>(place / limb_bits);
    return whole < size_ && ((limb_[whole] >> (place % limb_bits)) & 1) != 0;
  }

  [[nodiscard]] bool any_below(long place) const {
    const auto whole = static_cast<std::size_t>(place / limb_bits);
    if (whole >= size_) return true;
    if ((limb_[whole] & ((Limb(1) << (place % limb_bits)) - 1)) != 0) return true;
    return std::any_of(limb_.begin(), limb_.begin() + static_cast<std::ptrdiff_t>(whole),
                       [](Limb limb) { return limb != 0; });
  }

  std::size_t size_ = 0;
  std::array<Limb, room> limb_;
};

/// What all coefficients of a coordinate have in common.
struct Range {
  template <class Scalar>
  explicit Range(const CoordinateView<Scalar>& coefficients) {
    for (int i = 0; i <= coefficients.degree; ++i) {
      const auto value = static_cast<double>(coefficients[i]);
      finite = finite && std::isfinite(value);
      if (!finite || value == 0) continue;
      const Dyadic dyadic(value);
      lowest = std::min(lowest, dyadic.exponent);
      top = std::max(top, dyadic.top());
    }
  }
  [[nodiscard]] bool is_zero() const { return top < lowest; }
  [[nodiscard]] int width() const { return top - lowest; }

  bool finite = true;
  int lowest = std::numeric_limits<int>::max();  ///< all of them are multiples of 2^lowest
  int top = std::numeric_limits<int>::min();     ///< and below 2^top
};

template <class Scalar>
Scalar nothing() {
  return std::numeric_limits<Scalar>::quiet_NaN();
}

}  // namespace

template <class Scalar>
Scalar rounded_bernstein_sum(const CoordinateView<Scalar>& b, Scalar t) {
  const Range range(b);
  if (!range.finite || !(t >= 0 && t <= 1)) return nothing<Scalar>();
  if (range.is_zero()) return 0;
  const int n = b.degree;
  const Dyadic parameter(static_cast<double>(t));
  const int e = -parameter.exponent;
  WeightedPower weight(n, parameter.magnitude);
  Integer first;
  Integer second;
  Integer* sum = &first;
  Integer* next = &second;
  sum->set_zero(limbs(range.width() + n));
  for (int k = 0; k <= n; ++k) {
    if (k > 0) {
      next->set_difference(*sum, e, parameter.magnitude, limbs(range.width() + n + k * e));
      std::swap(sum, next);
      weight.advance();
    }
    const Dyadic term(static_cast<double>(b[k]));
    if (term.magnitude != 0)
      sum->add(weight.data(), weight.size(), term.magnitude, term.negative, term.exponent - range.lowest);
  }
  return sum->rounded<Scalar>(static_cast<long>(range.lowest) - static_cast<long>(n) * e);
}

template <class Scalar>
Scalar rounded_power_sum(const CoordinateView<Scalar>& q, Scalar t) {
  const Range range(q);
  if (!range.finite || !(t >= 0 && t <= 1)) return nothing<Scalar>();
  if (range.is_zero()) return 0;
  const int n = q.degree;
  const Dyadic parameter(static_cast<double>(t));
  const int e = -parameter.exponent;
  const int growth = static_cast<int>(std::bit_width(static_cast<unsigned>(n) + 1));  // a sum of n + 1 terms
  constexpr Limb one = 1;
  Integer first;
  Integer second;
  Integer* sum = &first;
  Integer* next = &second;
  sum->set_zero(limbs(range.width() + growth));
  for (int j = n; j >= 0; --j) {
    if (j < n) {
      next->set_product(*sum, parameter.magnitude, limbs(range.width() + growth + (n - j) * e));
      std::swap(sum, next);
    }
    const Dyadic term(static_cast<double>(q[j]));
    if (term.magnitude != 0)
      sum->add(&one, 1, term.magnitude, term.negative, term.exponent - range.lowest + (n - j) * e);
  }
  return sum->rounded<Scalar>(static_cast<long>(range.lowest) - static_cast<long>(n) * e);
}

template float rounded_bernstein_sum(const CoordinateView<float>&, float);
template double rounded_bernstein_sum(const CoordinateView<double>&, double);
template float rounded_power_sum(const CoordinateView<float>&, float);
template double rounded_power_sum(const CoordinateView<double>&, double);

}  // namespace bezierbench
