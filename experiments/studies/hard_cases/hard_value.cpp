// SPDX-License-Identifier: MIT
#include "experiments/studies/hard_cases/hard_value.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace bezierbench::studies {
namespace {

using reference::Rational;

/// floor(value) of a value >= 0.
mpz_class floor_of(const Rational& value) {
  mpz_class whole;
  const auto by = static_cast<mp_bitcnt_t>(std::abs(value.exponent));
  if (value.exponent >= 0)
    mpz_mul_2exp(whole.get_mpz_t(), value.numerator.get_mpz_t(), by);
  else
    mpz_fdiv_q_2exp(whole.get_mpz_t(), value.numerator.get_mpz_t(), by);
  return whole;
}

mpz_class power(unsigned long base, long exponent) {
  mpz_class result;
  mpz_ui_pow_ui(result.get_mpz_t(), base, static_cast<unsigned long>(exponent));
  return result;
}

Rational nearer(const Rational& a, const Rational& b) { return less(a, b) ? a : b; }

/// |value| 10^-lowest to the nearest integer, ties to even.
mpz_class rounded_at(const Rational& value, long lowest) {
  mpz_class numerator =
      ::abs(value.numerator) * power(2, std::max(0L, value.exponent)) * power(10, std::max(0L, -lowest));
  const mpz_class denominator = power(2, std::max(0L, -value.exponent)) * power(10, std::max(0L, lowest));
  mpz_class rest;
  mpz_fdiv_qr(numerator.get_mpz_t(), rest.get_mpz_t(), numerator.get_mpz_t(), denominator.get_mpz_t());
  const int half = cmp(mpz_class(2 * rest), denominator);
  if (half > 0 || (half == 0 && mpz_odd_p(numerator.get_mpz_t()) != 0)) ++numerator;
  return numerator;
}

}  // namespace

Rational boundary_distance(const reference::Format& format, const Rational& value) {
  const Rational half{1, 1, -1};
  long spacing = format.lowest_exponent;
  if (value.numerator != 0)
    spacing = std::clamp(floor_log2(value) - format.precision + 1, spacing, format.highest_exponent - format.precision);
  const Rational position{::abs(value.numerator), 1, value.exponent - spacing};
  const mpz_class below = floor_of(position);
  const mpz_class end = power(2, format.precision);
  if (below >= end) return position - (Rational{end} - half);
  const Rational above = position - Rational{below};  // in [0, 1)
  const Rational distance = abs(above - half);
  // Below a power of two numbers are half as far apart, and the midpoint a quarter of the spacing away.
  if (2 * below == end && spacing > format.lowest_exponent) return nearer(distance, above + Rational{1, 1, -2});
  return distance;
}

std::string significant(const Rational& value, int digits) {
  if (value.numerator == 0) return "0";
  constexpr double decades_per_binade = 0.30102999566398120;
  auto decade = static_cast<long>(std::floor(static_cast<double>(floor_log2(value)) * decades_per_binade));
  std::string text = rounded_at(value, decade - digits + 1).get_str();
  while (static_cast<int>(text.size()) != digits) {  // the first guess was from the binade, or rounding added a digit
    decade += static_cast<long>(text.size()) - digits;
    text = rounded_at(value, decade - digits + 1).get_str();
  }
  text.erase(text.find_last_not_of('0') + 1);
  if (text.size() > 1) text.insert(1, ".");
  return fmt::format("{}{}{}", value.numerator < 0 ? "-" : "", text, decade == 0 ? "" : fmt::format("e{:+}", decade));
}

}  // namespace bezierbench::studies
