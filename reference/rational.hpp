// SPDX-License-Identifier: MIT
// An exact number (numerator / denominator) 2^exponent in big integers, and its roundings.
//
// Doubles are dyadic rationals, so every value of a polynomial curve has denominator 1; a denominator appears only with
// the inverse conversion and with rational curves. Keeping the power of two apart avoids fractions altogether.
#pragma once

#include <gmpxx.h>

namespace bezierbench::reference {

/// (numerator / denominator) 2^exponent, denominator > 0; not kept in lowest terms.
struct Rational {
  mpz_class numerator = 0;
  mpz_class denominator = 1;
  long exponent = 0;
};

/// The value. Throws std::domain_error for an infinity or NaN, on which GMP would end the program.
double require_finite(double value);

/// A double, exactly. Throws as `require_finite`.
Rational exactly(double value);

/// The exact sum, difference, product and absolute value.
Rational operator+(const Rational& a, const Rational& b);
Rational operator-(const Rational& a, const Rational& b);
Rational operator*(const Rational& a, const Rational& b);
Rational abs(const Rational& a);

/// Whether a < b.
bool less(const Rational& a, const Rational& b);

/// A floating-point format to round into.
struct Format {
  int precision;          ///< significant bits
  long lowest_exponent;   ///< of the smallest subnormal
  long highest_exponent;  ///< numbers at or above 2^highest_exponent after rounding become infinite
};

inline constexpr Format binary64{53, -1074, 1024};
inline constexpr Format binary32{24, -149, 128};
/// The precision in which each trial's error is kept, in the range of double.
inline constexpr Format error_format{24, -1074, 1024};

/// To nearest, ties to even, once; overflow gives an infinity. The sign of zero is +.
double round_to(const Format& format, const Rational& value);

/// a / b to nearest, once, for b != 0.
double quotient(const Format& format, const Rational& a, const Rational& b);

/// The square root of a value >= 0 to nearest, once.
double square_root(const Format& format, const Rational& value);

/// floor(log2 |x|) for x != 0.
long floor_log2(const Rational& x);

/// ulp(x) = 2^(max(e, -1022) - 52) with 2^e <= |x| < 2^(e+1), and 2^-1074 at 0: the spacing of doubles at the exact x.
Rational ulp(const Rational& x);

}  // namespace bezierbench::reference
