/* SPDX-License-Identifier: MIT */
/*
 * The part of gmpxx.h that the reference uses, over Boost's cpp_int: GMP cannot be had for WebAssembly. It is found
 * there before the header of GMP, so that the reference is one and the same source, and GMP stays its integer elsewhere.
 * Each function has the meaning that GMP's manual gives it, for the arguments that the reference has: a base is 2, a
 * bit to start from is 0.
 */
#pragma once

#include <boost/multiprecision/cpp_int.hpp>
#include <cmath>
#include <compare>
#include <concepts>
#include <cstdint>
#include <string>
#include <utility>

using mp_bitcnt_t = unsigned long;

class mpz_class {
 public:
  using Value = boost::multiprecision::number<boost::multiprecision::cpp_int_backend<>, boost::multiprecision::et_off>;

  mpz_class() = default;
  explicit mpz_class(Value value) : value_(std::move(value)) {}
  template <std::integral Integer>
  mpz_class(Integer value) : value_(value) {}
  mpz_class(double value) : value_(value) {}

  [[nodiscard]] Value* get_mpz_t() { return &value_; }
  [[nodiscard]] const Value* get_mpz_t() const { return &value_; }
  [[nodiscard]] double get_d() const;
  [[nodiscard]] std::string get_str() const { return value_.str(); }

  mpz_class& operator+=(const mpz_class& b) { return value_ += b.value_, *this; }
  mpz_class& operator-=(const mpz_class& b) { return value_ -= b.value_, *this; }
  mpz_class& operator*=(const mpz_class& b) { return value_ *= b.value_, *this; }
  mpz_class& operator/=(const mpz_class& b) { return value_ /= b.value_, *this; }
  mpz_class& operator<<=(mp_bitcnt_t bits) { return value_ <<= bits, *this; }
  mpz_class& operator>>=(mp_bitcnt_t bits) { return value_ >>= bits, *this; }
  mpz_class& operator++() { return ++value_, *this; }
  mpz_class& operator--() { return --value_, *this; }
  mpz_class operator-() const { return mpz_class(Value(-value_)); }

  friend mpz_class operator+(mpz_class a, const mpz_class& b) { return a += b; }
  friend mpz_class operator-(mpz_class a, const mpz_class& b) { return a -= b; }
  friend mpz_class operator*(const mpz_class& a, const mpz_class& b) { return mpz_class(Value(a.value_ * b.value_)); }
  friend mpz_class operator/(const mpz_class& a, const mpz_class& b) { return mpz_class(Value(a.value_ / b.value_)); }
  friend mpz_class operator%(const mpz_class& a, const mpz_class& b) { return mpz_class(Value(a.value_ % b.value_)); }
  friend mpz_class operator<<(mpz_class a, mp_bitcnt_t bits) { return a <<= bits; }
  friend mpz_class operator>>(mpz_class a, mp_bitcnt_t bits) { return a >>= bits; }
  friend bool operator==(const mpz_class& a, const mpz_class& b) { return a.value_ == b.value_; }
  friend std::strong_ordering operator<=>(const mpz_class& a, const mpz_class& b) {
    return a.value_.compare(b.value_) <=> 0;
  }

 private:
  Value value_ = 0;
};

using mpz_ptr = mpz_class::Value*;
using mpz_srcptr = const mpz_class::Value*;

inline int sgn(const mpz_class& a) { return a.get_mpz_t()->sign(); }
inline mpz_class abs(const mpz_class& a) { return sgn(a) < 0 ? -a : a; }

inline void mpz_set_si(mpz_ptr result, std::int64_t value) { *result = value; }
inline void mpz_add(mpz_ptr sum, mpz_srcptr a, mpz_srcptr b) { *sum = *a + *b; }
inline void mpz_mul(mpz_ptr product, mpz_srcptr a, mpz_srcptr b) {
  eval_multiply(product->backend(), a->backend(), b->backend());
}
inline void mpz_addmul(mpz_ptr sum, mpz_srcptr a, mpz_srcptr b) {
  thread_local mpz_class::Value product;
  mpz_mul(&product, a, b);
  *sum += product;
}
inline void mpz_mul_2exp(mpz_ptr result, mpz_srcptr a, mp_bitcnt_t bits) { *result = *a << bits; }
inline void mpz_fdiv_q_2exp(mpz_ptr result, mpz_srcptr a, mp_bitcnt_t bits) { *result = *a >> bits; }
inline void mpz_tdiv_q_2exp(mpz_ptr result, mpz_srcptr a, mp_bitcnt_t bits) {
  const int sign = a->sign();
  *result = mpz_class::Value(abs(*a)) >> bits;
  if (sign < 0) *result = -*result;
}
inline int mpz_cmpabs(mpz_srcptr a, mpz_srcptr b) { return mpz_class::Value(abs(*a)).compare(abs(*b)); }
inline std::size_t mpz_sizeinbase(mpz_srcptr a, int /*base*/) { return a->is_zero() ? 1 : msb(abs(*a)) + 1; }
inline mp_bitcnt_t mpz_scan1(mpz_srcptr a, mp_bitcnt_t /*from*/) { return lsb(abs(*a)); }
inline int mpz_tstbit(mpz_srcptr a, mp_bitcnt_t bit) { return bit_test(*a, static_cast<unsigned>(bit)) ? 1 : 0; }
inline int mpz_odd_p(mpz_srcptr a) { return mpz_tstbit(a, 0); }

inline void mpz_tdiv_qr(mpz_ptr quotient, mpz_ptr remainder, mpz_srcptr a, mpz_srcptr b) {
  mpz_class::Value whole;
  mpz_class::Value rest;
  divide_qr(*a, *b, whole, rest);
  *quotient = std::move(whole);
  *remainder = std::move(rest);
}
inline void mpz_fdiv_qr(mpz_ptr quotient, mpz_ptr remainder, mpz_srcptr a, mpz_srcptr b) {
  const mpz_class::Value divisor = *b;
  mpz_tdiv_qr(quotient, remainder, a, b);
  if (remainder->sign() * divisor.sign() >= 0) return;
  --*quotient;
  *remainder += divisor;
}
inline void mpz_fdiv_q(mpz_ptr quotient, mpz_srcptr a, mpz_srcptr b) {
  mpz_class::Value remainder;
  mpz_fdiv_qr(quotient, &remainder, a, b);
}
inline unsigned long mpz_fdiv_ui(mpz_srcptr a, unsigned long b) {
  const mpz_class::Value remainder = *a % b;
  return static_cast<unsigned long>(remainder.sign() < 0 ? remainder + b : remainder);
}
inline void mpz_divexact(mpz_ptr quotient, mpz_srcptr a, mpz_srcptr b) { *quotient = *a / *b; }

inline void mpz_pow_ui(mpz_ptr result, mpz_srcptr base, unsigned long exponent) {
  *result = pow(*base, static_cast<unsigned>(exponent));
}
inline void mpz_fac_ui(mpz_ptr result, unsigned long n) {
  *result = 1;
  for (unsigned long i = 2; i <= n; ++i) *result *= i;
}
inline void mpz_bin_uiui(mpz_ptr result, unsigned long n, unsigned long k) {
  *result = k > n ? 0 : 1;
  for (unsigned long i = 0; i < k && i < n; ++i) {
    *result *= n - i;
    *result /= i + 1;
  }
}
inline void mpz_lcm(mpz_ptr result, mpz_srcptr a, mpz_srcptr b) { *result = lcm(*a, *b); }

/// The root is the limit of Newton's steps from above.
inline void mpz_sqrtrem(mpz_ptr root, mpz_ptr remainder, mpz_srcptr a) {
  mpz_class::Value current = 0;
  mpz_class::Value next = a->is_zero() ? mpz_class::Value(0) : mpz_class::Value(1) << (msb(*a) / 2 + 1);
  for (bool first = true; first || next < current; first = false) {
    current = next;
    if (!current.is_zero()) next = (current + *a / current) >> 1;
  }
  *remainder = *a - current * current;
  *root = std::move(current);
}
inline mpz_class sqrt(const mpz_class& a) {
  mpz_class root;
  mpz_class remainder;
  mpz_sqrtrem(root.get_mpz_t(), remainder.get_mpz_t(), a.get_mpz_t());
  return root;
}
inline mpz_class gcd(const mpz_class& a, const mpz_class& b) {
  return mpz_class(mpz_class::Value(gcd(*a.get_mpz_t(), *b.get_mpz_t())));
}

/// Truncates towards zero.
inline double mpz_class::get_d() const {
  const auto bits = static_cast<long>(mpz_sizeinbase(&value_, 2));
  const long dropped = bits > 53 ? bits - 53 : 0;
  const Value magnitude = abs(value_);
  const auto leading = static_cast<double>(static_cast<std::uint64_t>(Value(magnitude >> dropped)));
  return std::ldexp(value_.sign() < 0 ? -leading : leading, static_cast<int>(dropped));
}

/// In lowest terms at all times, so that canonicalize() does nothing.
class mpq_class {
 public:
  mpq_class() = default;
  template <std::integral Integer>
  mpq_class(Integer value) : numerator_(value) {}
  mpq_class(double value);
  explicit mpq_class(mpz_class numerator, mpz_class denominator = 1)
      : numerator_(std::move(numerator)), denominator_(std::move(denominator)) {
    reduce();
  }
  void canonicalize() {}

  [[nodiscard]] const mpz_class& get_num() const { return numerator_; }
  [[nodiscard]] const mpz_class& get_den() const { return denominator_; }
  [[nodiscard]] mpz_srcptr get_den_mpz_t() const { return denominator_.get_mpz_t(); }
  [[nodiscard]] std::string get_str() const {
    return denominator_ == 1 ? numerator_.get_str() : numerator_.get_str() + '/' + denominator_.get_str();
  }

  mpq_class& operator+=(const mpq_class& b) { return *this = *this + b; }
  mpq_class& operator-=(const mpq_class& b) { return *this = *this - b; }
  mpq_class& operator*=(const mpq_class& b) { return *this = *this * b; }
  mpq_class& operator/=(const mpq_class& b) { return *this = *this / b; }
  mpq_class& operator<<=(mp_bitcnt_t bits) { return *this = mpq_class(numerator_ << bits, denominator_); }
  mpq_class& operator>>=(mp_bitcnt_t bits) { return *this = mpq_class(numerator_, denominator_ << bits); }
  mpq_class operator-() const { return mpq_class(-numerator_, denominator_); }

  friend mpq_class operator+(const mpq_class& a, const mpq_class& b) {
    return mpq_class(a.numerator_ * b.denominator_ + b.numerator_ * a.denominator_, a.denominator_ * b.denominator_);
  }
  friend mpq_class operator-(const mpq_class& a, const mpq_class& b) { return a + -b; }
  friend mpq_class operator*(const mpq_class& a, const mpq_class& b) {
    return mpq_class(a.numerator_ * b.numerator_, a.denominator_ * b.denominator_);
  }
  friend mpq_class operator/(const mpq_class& a, const mpq_class& b) {
    return mpq_class(a.numerator_ * b.denominator_, a.denominator_ * b.numerator_);
  }
  friend bool operator==(const mpq_class& a, const mpq_class& b) = default;
  friend std::strong_ordering operator<=>(const mpq_class& a, const mpq_class& b) {
    return a.numerator_ * b.denominator_ <=> b.numerator_ * a.denominator_;
  }

 private:
  void reduce() {
    if (denominator_ < 0) {
      numerator_ = -numerator_;
      denominator_ = -denominator_;
    }
    const mpz_class common = gcd(numerator_, denominator_);
    if (common == 1) return;
    numerator_ /= common;
    denominator_ /= common;
  }

  mpz_class numerator_ = 0;
  mpz_class denominator_ = 1;
};

inline mpq_class::mpq_class(double value) {
  int exponent = 0;
  numerator_ = std::ldexp(std::frexp(value, &exponent), 53);
  exponent -= 53;
  if (exponent >= 0)
    numerator_ <<= static_cast<mp_bitcnt_t>(exponent);
  else
    denominator_ <<= static_cast<mp_bitcnt_t>(-exponent);
  reduce();
}

inline int sgn(const mpq_class& a) { return sgn(a.get_num()); }
inline mpq_class abs(const mpq_class& a) { return sgn(a) < 0 ? -a : a; }
