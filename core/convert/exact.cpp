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
  const cpp_int n = abs(numerator);
  const auto shifted = [](const cpp_int& number, int by) { return by > 0 ? cpp_int(number << by) : number; };
  // Scaled so that the quotient has `precision` bits, or is in units of the smallest subnormal.
  const int size = static_cast<int>(msb(n)) - static_cast<int>(msb(denominator));
  const bool reached = shifted(n, -size) >= shifted(denominator, size);  // n / denominator >= 2^size
  const int shift = std::min(precision - size - (reached ? 1 : 0), exponent - lowest_exponent);
  const cpp_int divisor = shifted(denominator, -shift);
  cpp_int quotient;
  cpp_int remainder;
  divide_qr(shifted(n, shift), divisor, quotient, remainder);
  const int against_half = cpp_int(remainder * 2).compare(divisor);
  if (against_half > 0 || (against_half == 0 && bit_test(quotient, 0))) ++quotient;
  const double magnitude = std::ldexp(static_cast<double>(quotient), exponent - shift);
  const double rounded = magnitude > largest ? std::numeric_limits<double>::infinity() : magnitude;
  return negative ? -rounded : rounded;
}

/// Combines every number with the next one; one number less remains.
template <class Combine>
void combine_with_next(std::vector<cpp_int>& numbers, Combine combine) {
  for (std::size_t i = 0; i + 1 < numbers.size(); ++i) combine(numbers[i], numbers[i + 1]);
  numbers.pop_back();
}

/// Hands over C(n,j) and the differences D^j b_0 .. D^j b_(n-j) for j = 0..n, as integers times 2^exponent.
template <class Receive>
void for_each_order(std::span<const double> in, Receive receive) {
  auto [differences, exponent] = aligned<cpp_int>(in);
  cpp_int binomial = 1;
  for (std::size_t j = 0; j < in.size(); ++j) {
    receive(j, binomial, differences, exponent);
    combine_with_next(differences, [](cpp_int& here, const cpp_int& next) { here = next - here; });
    binomial = binomial * (in.size() - 1 - j) / (j + 1);
  }
}

}  // namespace

void exact_to_power(std::span<const double> in, std::span<double> out, RoundTo target) {
  for_each_order(in, [&](std::size_t j, const cpp_int& binomial, const auto& differences, int exponent) {
    out[j] = round_quotient(binomial * differences[0], 1, exponent, target);
  });
}

void exact_to_power_double_double(std::span<const double> in, std::span<double> high, std::span<double> low,
                                  RoundTo target) {
  for_each_order(in, [&](std::size_t j, const cpp_int& binomial, const auto& differences, int exponent) {
    cpp_int remainder = binomial * differences[0];
    high[j] = round_quotient(remainder, 1, exponent, target);
    low[j] = 0;
    if (!std::isfinite(high[j])) return;
    const auto [significand, high_exponent] = split_double(high[j]);
    cpp_int rounded = significand;
    if (high_exponent > exponent)
      rounded <<= static_cast<unsigned>(high_exponent - exponent);
    else
      remainder <<= static_cast<unsigned>(exponent - high_exponent);
    remainder -= rounded;
    low[j] = round_quotient(remainder, 1, std::min(exponent, high_exponent), target);
  });
}

void exact_to_power_centered(std::span<const double> in, std::span<double> out, RoundTo target) {
  for_each_order(in, [&](std::size_t j, const cpp_int& binomial, const auto& differences, int exponent) {
    const std::size_t m = in.size() - 1 - j;
    cpp_int sum = 0;
    cpp_int weight = 1;  // C(m,i)
    for (std::size_t i = 0; i <= m; ++i) {
      sum += weight * differences[i];
      weight = weight * (m - i) / (i + 1);
    }
    out[j] = round_quotient(binomial * sum, 1, exponent - static_cast<int>(m), target);
  });
}

void exact_to_bernstein(std::span<const double> in, std::span<double> out, RoundTo target) {
  auto [sums, exponent] = aligned<cpp_int>(in);
  const std::size_t n = in.size() - 1;
  std::vector<cpp_int> factorial(n + 1, 1);
  for (std::size_t k = 1; k <= n; ++k) factorial[k] = factorial[k - 1] * k;
  for (std::size_t j = 0; j <= n; ++j) sums[j] *= factorial[j] * factorial[n - j];
  for (double& b : out) {
    b = round_quotient(sums[0], factorial[n], exponent, target);
    combine_with_next(sums, [](cpp_int& here, const cpp_int& next) { here += next; });
  }
}

}  // namespace bezierbench
