// SPDX-License-Identifier: MIT
// With K = 2U + 1 and M = 2^129 the image is (a (M - K) + b K) / M.
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

#include "experiments/sample/words.hpp"
#include "reference/rational.hpp"

namespace bezierbench::sample {
namespace {

__extension__ using Wide = unsigned __int128;

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

/// m (2U + 1), below 2^182, least significant word first.
std::array<std::uint64_t, 3> times_odd(std::uint64_t m, Uniform128 u) {
  const Wide low = Wide{m} * u.low;
  const Wide high = Wide{m} * u.high + (low >> 64U);
  const Wide first = (Wide{static_cast<std::uint64_t>(low)} << 1U) + m;
  const Wide second = (Wide{static_cast<std::uint64_t>(high)} << 1U) + (first >> 64U);
  const Wide third = (high >> 64U << 1U) + (second >> 64U);
  return {static_cast<std::uint64_t>(first), static_cast<std::uint64_t>(second), static_cast<std::uint64_t>(third)};
}

double rounded_in_general(double a, double b, Uniform128 u) {
  const mpz_class k = 2 * ((mpz_class(u.high) << 64U) + mpz_class(u.low)) + 1;
  const mpz_class rest = (mpz_class(1) << 129U) - k;
  const auto image = reference::exactly(a) * reference::Rational{rest, 1, -129} +
                     reference::exactly(b) * reference::Rational{k, 1, -129};
  return std::copysign(reference::round_to(reference::binary64, image), sgn(image.numerator) < 0 ? -1 : 1);
}

/// +-m (2U + 1) 2^exponent where the product reaches into its third word and the result is normal; NaN elsewhere.
double rounded_product(bool negative, std::uint64_t m, Uniform128 u, int exponent) {
  const auto [w0, w1, w2] = times_odd(m, u);
  const int zeros = std::countl_zero(w2);
  const int last = exponent + 192 - zeros - 53;  // exponent of the last bit kept
  if (zeros == 0 || zeros == 64 || last < smallest_exponent) return std::numeric_limits<double>::quiet_NaN();
  const std::uint64_t top = w2 << zeros | w1 >> (64 - zeros);
  const bool sticky = (w1 << zeros | w0) != 0;
  const std::uint64_t below = (top & 0x7ffU) | (sticky ? 1U : 0U);  // out of 2048; a half is 1024
  const std::uint64_t kept = (top >> 11U) + (below + (top >> 11U & 1U) > 1024U ? 1U : 0U);
  // Adding the leading bit of `kept`, or a carry out of rounding, raises the exponent field by one.
  const std::uint64_t word = (static_cast<std::uint64_t>(last - smallest_exponent) << 52U) + kept;
  return std::bit_cast<double>(word | static_cast<std::uint64_t>(negative) << 63U);
}

}  // namespace

// The intervals [-R, R], [0, b] and [a, 0] are by far the most frequent; for them the image is a single product.
double affine(double a, double b, Uniform128 u) {
  const Unpacked from = unpack(a);
  const Unpacked to = unpack(b);
  // M - K = 2 (2^128 - 1 - U) + 1, and 2^128 - 1 - U is the complement of U.
  const Uniform128 complement{~u.high, ~u.low};
  double product = std::numeric_limits<double>::quiet_NaN();
  if (a == -b) {
    // b (2K - M) / M, where 2K - M is twice the odd number 2 (U - 2^127) + 1.
    const bool negative = u.high < top_bit;
    const Uniform128 v = negative ? complement : u;
    product = rounded_product(negative, to.magnitude, {v.high & ~top_bit, v.low}, to.exponent + 1 - 129);
  } else if (a == 0) {
    product = rounded_product(to.negative, to.magnitude, u, to.exponent - 129);
  } else if (b == 0) {
    product = rounded_product(from.negative, from.magnitude, complement, from.exponent - 129);
  }
  return std::isnan(product) ? rounded_in_general(a, b, u) : product;
}

}  // namespace bezierbench::sample
