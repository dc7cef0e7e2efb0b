// SPDX-License-Identifier: MIT
#include "core/convert/exact.hpp"

#include <algorithm>
#include <boost/multiprecision/cpp_int.hpp>
#include <cmath>
#include <limits>
#include <vector>

#include "core/split_double.hpp"

namespace bezierbench {
namespace {

using boost::multiprecision::cpp_int;

/// (numerator / denominator) 2^exponent to nearest, ties to even, with gradual underflow and overflow to infinity.
double round_quotient(const cpp_int& numerator, const cpp_int& denominator, int exponent, RoundTo target) {
  if (numerator == 0) return 0;
  const bool negative = numerator < 0;
  const int precision = target == RoundTo::binary64 ? 53 : 24;
  const int lowest_exponent = target == RoundTo::binary64 ? -1074 : -149;
  const double largest = target == RoundTo::binary64 ? std::numeric_limits<double>::max()
                                                     : static_cast<double>(std::numeric_limits<float>::max());
  cpp_int n = abs(numerator);
  cpp_int d = denominator;
  // Scale so that the quotient has `precision` or precision + 1 bits, or is in units of the smallest subnormal.
  int shift = precision - (static_cast<int>(msb(n)) - static_cast<int>(msb(d)));
  shift = std::min(shift, exponent - lowest_exponent);
  auto scaled_quotient = [&](int by, cpp_int& remainder) {
    cpp_int scaled_n = by >= 0 ? cpp_int(n << static_cast<unsigned>(by)) : n;
    cpp_int scaled_d = by >= 0 ? d : cpp_int(d << static_cast<unsigned>(-by));
    cpp_int quotient;
    divide_qr(scaled_n, scaled_d, quotient, remainder);
    remainder *= 2;
    const int against_half = remainder.compare(scaled_d);
    remainder = against_half;
    return quotient;
  };
  cpp_int against_half;
  cpp_int quotient = scaled_quotient(shift, against_half);
  if (quotient != 0 && static_cast<int>(msb(quotient)) + 1 > precision)
    quotient = scaled_quotient(--shift, against_half);
  if (against_half > 0 || (against_half == 0 && bit_test(quotient, 0))) ++quotient;
  const double magnitude = std::ldexp(static_cast<double>(quotient), exponent - shift);
  const double rounded = magnitude > largest ? std::numeric_limits<double>::infinity() : magnitude;
  return negative ? -rounded : rounded;
}

/// Row i of Pascal's triangle from row i - 1, in place.
void next_row(std::vector<cpp_int>& row) {
  row.emplace_back(1);
  for (std::size_t k = row.size() - 2; k >= 1; --k) row[k] += row[k - 1];
}

/// Hands over every q_j = C(n,j) D^j b_0, as an integer times 2^exponent.
template <class Receive>
void for_each_power_coefficient(std::span<const double> in, Receive receive) {
  const auto b = aligned<cpp_int>(in);
  std::vector<cpp_int> difference = b.integers;
  cpp_int binomial = 1;
  const std::size_t n = in.size() - 1;
  for (std::size_t j = 0; j <= n; ++j) {
    receive(j, cpp_int(binomial * difference[0]), b.exponent);
    for (std::size_t i = 0; i < n - j; ++i) difference[i] = difference[i + 1] - difference[i];
    binomial = binomial * (n - j) / (j + 1);
  }
}

}  // namespace

void exact_to_power(std::span<const double> in, std::span<double> out, RoundTo target) {
  for_each_power_coefficient(in, [&](std::size_t j, const cpp_int& coefficient, int exponent) {
    out[j] = round_quotient(coefficient, 1, exponent, target);
  });
}

void exact_to_power_double_double(std::span<const double> in, std::span<double> high, std::span<double> low,
                                  RoundTo target) {
  for_each_power_coefficient(in, [&](std::size_t j, const cpp_int& coefficient, int exponent) {
    high[j] = round_quotient(coefficient, 1, exponent, target);
    low[j] = 0;
    if (!std::isfinite(high[j])) return;
    const auto [significand, high_exponent] = split_double(high[j]);
    cpp_int rounded = significand;
    cpp_int remainder = coefficient;
    if (high_exponent > exponent)
      rounded <<= static_cast<unsigned>(high_exponent - exponent);
    else
      remainder <<= static_cast<unsigned>(exponent - high_exponent);
    remainder -= rounded;
    low[j] = round_quotient(remainder, 1, std::min(exponent, high_exponent), target);
  });
}

void exact_to_power_centered(std::span<const double> in, std::span<double> out, RoundTo target) {
  const auto b = aligned<cpp_int>(in);
  std::vector<cpp_int> difference = b.integers;
  cpp_int binomial = 1;
  const std::size_t n = in.size() - 1;
  for (std::size_t j = 0; j <= n; ++j) {
    cpp_int sum = 0;
    cpp_int weight = 1;  // C(n-j, i)
    for (std::size_t i = 0; i <= n - j; ++i) {
      sum += weight * difference[i];
      weight = weight * (n - j - i) / (i + 1);
    }
    out[j] = round_quotient(binomial * sum, 1, b.exponent - static_cast<int>(n - j), target);
    for (std::size_t i = 0; i < n - j; ++i) difference[i] = difference[i + 1] - difference[i];
    binomial = binomial * (n - j) / (j + 1);
  }
}

void exact_to_bernstein(std::span<const double> in, std::span<double> out, RoundTo target) {
  auto q = aligned<cpp_int>(in);
  const std::size_t n = in.size() - 1;
  std::vector<cpp_int> factorial(n + 1, 1);
  for (std::size_t k = 1; k <= n; ++k) factorial[k] = factorial[k - 1] * k;
  for (std::size_t j = 0; j <= n; ++j) q.integers[j] *= factorial[j] * factorial[n - j];
  std::vector<cpp_int> binomial;
  for (std::size_t i = 0; i <= n; ++i) {
    if (i == 0)
      binomial.assign(1, 1);
    else
      next_row(binomial);
    cpp_int sum = 0;
    for (std::size_t j = 0; j <= i; ++j) sum += binomial[j] * q.integers[j];
    out[i] = round_quotient(sum, factorial[n], q.exponent, target);
  }
}

}  // namespace bezierbench
