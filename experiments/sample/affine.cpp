// SPDX-License-Identifier: MIT
// With K = 2U + 1 and M = 2^129 the image is (a (M - K) + b K) / M. Both products have at most 53 + 129 = 182 bits and
// are computed exactly. 256 bits hold their sum exactly unless the exponents of a and b are far apart; see add().
#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <utility>

#include "experiments/sample/words.hpp"

namespace bezierbench::sample {
namespace {

__extension__ using Wide = unsigned __int128;

/// A non-negative integer of 256 bits, least significant word first.
using Bits256 = std::array<std::uint64_t, 4>;

constexpr int bits = 256;
constexpr std::uint64_t top_bit = std::uint64_t{1} << 63U;
constexpr int smallest_exponent = -1074;  // exponent of the last bit of the smallest double

/// +-magnitude 2^exponent; `magnitude` is below 2^53.
struct Unpacked {
  bool negative;
  std::uint64_t magnitude;
  int exponent;
};

Unpacked unpack(double x) {
  const auto word = std::bit_cast<std::uint64_t>(x);
  const std::uint64_t fraction = word & 0xfffffffffffffU;
  const int biased = static_cast<int>(word >> 52U & 0x7ffU);
  const bool normal = biased != 0;
  return {(word >> 63U) != 0, fraction | (normal ? std::uint64_t{1} << 52U : 0U),
          (normal ? biased : 1) - 1 + smallest_exponent};
}

int width(std::uint64_t x) { return 64 - std::countl_zero(x); }

int bit_length(const Bits256& x) {
  for (int i = 3; i > 0; --i) {
    if (x[static_cast<std::size_t>(i)] != 0) return 64 * i + width(x[static_cast<std::size_t>(i)]);
  }
  return width(x[0]);
}

/// m (2U + 1), below 2^182.
Bits256 times_odd(std::uint64_t m, Uniform128 u) {
  const Wide low = Wide{m} * u.low;
  const Wide high = Wide{m} * u.high + (low >> 64U);
  // 2 m U + m
  const auto w0 = static_cast<std::uint64_t>(low);
  const auto w1 = static_cast<std::uint64_t>(high);
  const auto w2 = static_cast<std::uint64_t>(high >> 64U);
  Wide sum = (Wide{w0} << 1U) + m;
  Bits256 product{};
  product[0] = static_cast<std::uint64_t>(sum);
  sum = (Wide{w1} << 1U) + (sum >> 64U);
  product[1] = static_cast<std::uint64_t>(sum);
  sum = (Wide{w2} << 1U) + (sum >> 64U);
  product[2] = static_cast<std::uint64_t>(sum);
  return product;
}

Bits256 shift_left(const Bits256& x, int count) {
  const auto words = static_cast<std::size_t>(count / 64);
  const auto rest = static_cast<unsigned>(count % 64);
  Bits256 shifted{};
  for (std::size_t i = words; i < 4; ++i) {
    shifted[i] = x[i - words] << rest;
    if (rest != 0 && i > words) shifted[i] |= x[i - words - 1] >> (64U - rest);
  }
  return shifted;
}

/// floor(x / 2^count). The last bit is also set where bits were lost (sticky), so that later roundings take them into
/// account.
Bits256 shift_right_sticky(const Bits256& x, int count) {
  if (count >= bits) return {bit_length(x) != 0 ? 1U : 0U, 0, 0, 0};
  const auto words = static_cast<std::size_t>(count / 64);
  const auto rest = static_cast<unsigned>(count % 64);
  std::uint64_t lost = 0;
  for (std::size_t i = 0; i < words; ++i) lost |= x[i];
  if (rest != 0) lost |= x[words] << (64U - rest);
  Bits256 shifted{};
  for (std::size_t i = words; i < 4; ++i) {
    shifted[i - words] = x[i] >> rest;
    if (rest != 0 && i < 3) shifted[i - words] |= x[i + 1] << (64U - rest);
  }
  shifted[0] |= lost != 0 ? 1U : 0U;
  return shifted;
}

Bits256 plus(const Bits256& x, const Bits256& y) {
  Bits256 sum;
  Wide carry = 0;
  for (std::size_t i = 0; i < 4; ++i) {
    carry += Wide{x[i]} + y[i];
    sum[i] = static_cast<std::uint64_t>(carry);
    carry >>= 64U;
  }
  return sum;
}

/// Sets `difference` to x - y modulo 2^256. Returns whether x < y.
bool subtract(const Bits256& x, const Bits256& y, Bits256& difference) {
  std::uint64_t borrow = 0;
  for (std::size_t i = 0; i < 4; ++i) {
    const Wide d = Wide{x[i]} - y[i] - borrow;
    difference[i] = static_cast<std::uint64_t>(d);
    borrow = static_cast<std::uint64_t>(d >> 64U) & 1U;
  }
  return borrow != 0;
}

/// A sum of two terms, before rounding.
struct Term {
  bool negative;
  Bits256 magnitude;
  int exponent;
};

/// x + y, exact up to a sticky bit. The term with the larger exponent is shifted left, as far as 254 bits allow. Where
/// that is not far enough, this term has all of 254 bits and the other one, shifted right, has at most 181. Then at
/// most one bit cancels, and a sticky bit holds all that rounding needs of the bits lost.
Term add(Term x, Term y) {
  if (x.exponent < y.exponent) std::swap(x, y);
  if (const int apart = x.exponent - y.exponent; apart > 0) {
    const int left = std::min(apart, bits - 2 - bit_length(x.magnitude));
    x.magnitude = shift_left(x.magnitude, left);
    x.exponent -= left;
    if (left < apart) y.magnitude = shift_right_sticky(y.magnitude, apart - left);
  }
  if (x.negative == y.negative) return {x.negative, plus(x.magnitude, y.magnitude), x.exponent};
  Bits256 difference;
  if (!subtract(x.magnitude, y.magnitude, difference)) return {x.negative, difference, x.exponent};
  subtract(y.magnitude, x.magnitude, difference);
  return {y.negative, difference, x.exponent};
}

/// The bits [from, from + 64) of x.
std::uint64_t word_at(const Bits256& x, int from) {
  const auto word = static_cast<std::size_t>(from / 64);
  const auto rest = static_cast<unsigned>(from % 64);
  const std::uint64_t low = x[word] >> rest;
  return rest == 0 || word == 3 ? low : low | x[word + 1] << (64U - rest);
}

bool any_below(const Bits256& x, int count) {
  const auto words = static_cast<std::size_t>(count / 64);
  std::uint64_t found = x[words] & ((std::uint64_t{1} << static_cast<unsigned>(count % 64)) - 1U);
  for (std::size_t i = 0; i < words; ++i) found |= x[i];
  return found != 0;
}

/// `kept` 2^last as a double. Adding the leading bit of a normal `kept`, or a carry out of rounding, raises the
/// exponent field by one.
double pack(bool negative, std::uint64_t kept, int last) {
  const std::uint64_t word = (static_cast<std::uint64_t>(last - smallest_exponent) << 52U) + kept;
  return std::bit_cast<double>(word | static_cast<std::uint64_t>(negative) << 63U);
}

double rounded_in_general(const Term& x) {
  const int length = bit_length(x.magnitude);
  if (length == 0) return 0;
  const int last = std::max(x.exponent + length - 53, smallest_exponent);  // exponent of the last bit kept
  const int drop = last - x.exponent;
  if (drop <= 0) return pack(x.negative, x.magnitude[0] << static_cast<unsigned>(-drop), last);
  std::uint64_t kept = word_at(x.magnitude, drop) & ((std::uint64_t{1} << 53U) - 1U);
  const bool half = (word_at(x.magnitude, drop - 1) & 1U) != 0;
  kept += half && ((kept & 1U) != 0 || any_below(x.magnitude, drop - 1)) ? 1U : 0U;
  return pack(x.negative, kept, last);
}

/// The same as rounded_in_general(), but faster where three words hold the value, the third is not 0 and the result is
/// normal.
double rounded(const Term& x) {
  const auto& [w0, w1, w2, w3] = x.magnitude;
  const int zeros = std::countl_zero(w2);
  const int last = x.exponent + 192 - zeros - 53;
  if (w3 != 0 || zeros == 0 || zeros == 64 || last < smallest_exponent) return rounded_in_general(x);
  const std::uint64_t top = w2 << zeros | w1 >> (64 - zeros);
  const bool sticky = (w1 << zeros | w0) != 0;
  const std::uint64_t below = (top & 0x7ffU) | (sticky ? 1U : 0U);  // out of 2048; a half is 1024
  const std::uint64_t kept = top >> 11U;
  return pack(x.negative, kept + (below + (kept & 1U) > 1024U ? 1U : 0U), last);
}

}  // namespace

double affine(double a, double b, Uniform128 u) {
  const Unpacked from = unpack(a);
  const Unpacked to = unpack(b);
  // M - K = 2 (2^128 - 1 - U) + 1, and 2^128 - 1 - U is the complement of U.
  const Uniform128 complement{~u.high, ~u.low};
  // The intervals [-R, R] and [0, b] are by far the most frequent; for them the image is a single product.
  if (from.magnitude == to.magnitude && from.exponent == to.exponent && from.negative != to.negative) {
    // b (2K - M) / M, where 2K - M is twice the odd number 2 (U - 2^127) + 1.
    const bool negative = u.high < top_bit;
    const Uniform128 v = negative ? complement : u;
    return rounded({negative, times_odd(to.magnitude, {v.high & ~top_bit, v.low}), to.exponent + 1 - 129});
  }
  const Term at_b{to.negative, times_odd(to.magnitude, u), to.exponent - 129};
  if (from.magnitude == 0) return rounded(at_b);
  const Term at_a{from.negative, times_odd(from.magnitude, complement), from.exponent - 129};
  if (to.magnitude == 0) return rounded(at_a);
  return rounded(add(at_a, at_b));
}

}  // namespace bezierbench::sample
