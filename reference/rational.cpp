// SPDX-License-Identifier: MIT
#include "reference/rational.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace bezierbench::reference {
namespace {

long bits(const mpz_class& a) { return a == 0 ? 0 : static_cast<long>(mpz_sizeinbase(a.get_mpz_t(), 2)); }

mpz_class shifted(const mpz_class& a, long by) {
  mpz_class result;
  if (by >= 0)
    mpz_mul_2exp(result.get_mpz_t(), a.get_mpz_t(), static_cast<mp_bitcnt_t>(by));
  else
    mpz_fdiv_q_2exp(result.get_mpz_t(), a.get_mpz_t(), static_cast<mp_bitcnt_t>(-by));
  return result;
}

/// Brings two values to one exponent.
void align(mpz_class& a, long& a_exponent, mpz_class& b, long& b_exponent) {
  const long lower = std::min(a_exponent, b_exponent);
  a = shifted(a, a_exponent - lower);
  b = shifted(b, b_exponent - lower);
  a_exponent = b_exponent = lower;
}

/// integer 2^exponent, plus a number in (0, 1) 2^exponent if `more`, rounded to the format. The integer must have more
/// bits than the precision, or reach below the lowest exponent, or be exact.
double round_integer(const Format& format, mpz_class integer, long exponent, bool more) {
  if (integer == 0 && !more) return 0;
  const long drop = std::max(bits(integer) - format.precision, format.lowest_exponent - exponent);
  if (drop > 0) {
    const auto count = static_cast<mp_bitcnt_t>(drop);
    const bool half = mpz_tstbit(integer.get_mpz_t(), count - 1) != 0;
    const bool below_half = more || (integer != 0 && mpz_scan1(integer.get_mpz_t(), 0) < count - 1);
    integer = shifted(integer, -drop);
    if (half && (below_half || mpz_odd_p(integer.get_mpz_t()) != 0)) ++integer;
    exponent += drop;
  }
  if (bits(integer) + exponent > format.highest_exponent) return std::numeric_limits<double>::infinity();
  return std::ldexp(integer.get_d(), static_cast<int>(exponent));
}

}  // namespace

double require_finite(double value) {
  if (!std::isfinite(value)) throw std::domain_error("bezierbench: an infinity or NaN has no exact value");
  return value;
}

Rational exactly(double value) {
  int exponent = 0;
  const double mantissa = std::frexp(require_finite(value), &exponent);
  Rational result;
  result.numerator = std::ldexp(mantissa, 53);
  result.exponent = value == 0 ? 0 : exponent - 53;
  return result;
}

Rational operator+(const Rational& a, const Rational& b) {
  mpz_class x = a.numerator * b.denominator;
  mpz_class y = b.numerator * a.denominator;
  long x_exponent = a.exponent;
  long y_exponent = b.exponent;
  if (x == 0) x_exponent = y_exponent;
  if (y == 0) y_exponent = x_exponent;
  align(x, x_exponent, y, y_exponent);
  return {x + y, a.denominator * b.denominator, x_exponent};
}

Rational operator-(const Rational& a, const Rational& b) {
  return a + Rational{-b.numerator, b.denominator, b.exponent};
}

Rational operator*(const Rational& a, const Rational& b) {
  return {a.numerator * b.numerator, a.denominator * b.denominator, a.exponent + b.exponent};
}

Rational abs(const Rational& a) { return {::abs(a.numerator), a.denominator, a.exponent}; }

bool less(const Rational& a, const Rational& b) { return sgn((a - b).numerator) < 0; }

double round_to(const Format& format, const Rational& value) {
  const bool negative = value.numerator < 0;
  mpz_class integer = ::abs(value.numerator);
  long exponent = value.exponent;
  bool more = false;
  if (value.denominator != 1) {
    const long extra = std::max(0L, format.precision + 2 - (bits(integer) - bits(value.denominator)));
    mpz_class remainder;
    integer = shifted(integer, extra);
    mpz_fdiv_qr(integer.get_mpz_t(), remainder.get_mpz_t(), integer.get_mpz_t(), value.denominator.get_mpz_t());
    more = remainder != 0;
    exponent -= extra;
  }
  const double magnitude = round_integer(format, integer, exponent, more);
  return negative ? -magnitude : magnitude;
}

double quotient(const Format& format, const Rational& a, const Rational& b) {
  const mpz_class sign = b.numerator < 0 ? -1 : 1;
  return round_to(format,
                  {a.numerator * b.denominator * sign, a.denominator * ::abs(b.numerator), a.exponent - b.exponent});
}

double square_root(const Format& format, const Rational& value) {
  // sqrt(N/D 2^e) = sqrt(N D 2^e) / D: shift N D so that the integer root has precision + 2 bits and e is even.
  mpz_class radicand = value.numerator * value.denominator;
  if (radicand == 0) return 0;
  long extra = std::max(0L, 2 * (format.precision + 2 + bits(value.denominator)) - bits(radicand));
  if ((value.exponent - extra) % 2 != 0) ++extra;
  radicand = shifted(radicand, extra);
  mpz_class root;
  mpz_class remainder;
  mpz_sqrtrem(root.get_mpz_t(), remainder.get_mpz_t(), radicand.get_mpz_t());
  bool more = remainder != 0;
  if (value.denominator != 1) {
    mpz_fdiv_qr(root.get_mpz_t(), remainder.get_mpz_t(), root.get_mpz_t(), value.denominator.get_mpz_t());
    more = more || remainder != 0;
  }
  return round_integer(format, root, (value.exponent - extra) / 2, more);
}

long floor_log2(const Rational& x) {
  // From the bit lengths, corrected by one comparison.
  long e = bits(x.numerator) - bits(x.denominator);
  mpz_class magnitude = ::abs(x.numerator);
  mpz_class scaled = x.denominator;
  if (e >= 0)
    scaled = shifted(scaled, e);
  else
    magnitude = shifted(magnitude, -e);
  if (magnitude < scaled) --e;
  return e + x.exponent;
}

Rational ulp(const Rational& x) {
  if (x.numerator == 0) return {1, 1, -1074};
  return {1, 1, std::max(floor_log2(x), -1022L) - 52};
}

}  // namespace bezierbench::reference
