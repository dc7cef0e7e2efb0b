// SPDX-License-Identifier: MIT
// Polynomials with integer coefficients, and their real roots in [0, 1].
#pragma once

#include <gmpxx.h>

#include <vector>

#include "reference/rational.hpp"

namespace bezierbench::reference {

/// Coefficients, ascending; the last one is not 0. The zero polynomial has none.
using IntegerPolynomial = std::vector<mpz_class>;

/// From the coefficients of sum c_k t^k (1-t)^(m-k), ascending.
IntegerPolynomial from_scaled_bernstein(const std::vector<mpz_class>& c);

/// The polynomial with the Bernstein coefficients b, over 2^exponent.
IntegerPolynomial from_bernstein(const std::vector<Rational>& b, long& exponent);

IntegerPolynomial derivative(const IntegerPolynomial& p);

IntegerPolynomial product(const IntegerPolynomial& a, const IntegerPolynomial& b);

IntegerPolynomial difference(IntegerPolynomial a, const IntegerPolynomial& b);

/// p(1 - t).
IntegerPolynomial mirrored(IntegerPolynomial p);

/// The greatest common divisor, up to a factor; primitive. For two zero polynomials it is zero.
IntegerPolynomial greatest_common_divisor(IntegerPolynomial a, IntegerPolynomial b);

/// The polynomial with each complex root of p once, up to a factor; p is not zero.
IntegerPolynomial square_free(const IntegerPolynomial& p);

/// Square-free polynomials a_1, a_2, ... with p = a_1 a_2^2 a_3^3 ... up to a factor; p is not zero ([Musser 1971]).
std::vector<IntegerPolynomial> square_free_factors(const IntegerPolynomial& p);

/// The polynomial p of least degree with p(value) = 0 modulo `modulus`, up to a factor; the degree of `modulus` is at
/// least 1. Where `modulus` is square-free, p is, too, and its roots are the values of `value` at the roots of
/// `modulus`: p is the least common multiple of their minimal polynomials.
IntegerPolynomial minimal_polynomial(const IntegerPolynomial& value, const IntegerPolynomial& modulus);

/// k / 2^shift.
struct Dyadic {
  mpz_class k;
  unsigned long shift = 0;
};

/// p(k / 2^shift) 2^(m shift), m the degree of p.
mpz_class value_at(const IntegerPolynomial& p, const Dyadic& t);

/// The sign of p at t.
int sign_at(const IntegerPolynomial& p, const Dyadic& t);

/// True only if p has exactly one root in the open interval from `low` to low + width / 2^low.shift, by Descartes'
/// rule; it is simple. True for a narrow enough interval about a simple root.
bool has_one_root(IntegerPolynomial p, const Dyadic& low, const mpz_class& width);

/// An interval [k, k + 1] / 2^shift with one root inside; or the root k / 2^shift itself, if `exact`.
struct RootInterval {
  Dyadic t;
  bool exact = false;
};

/// One interval for each root of the square-free, non-zero p in [0, 1], in ascending order: halving, with Descartes'
/// rule of signs ([Collins and Akritas 1976]).
std::vector<RootInterval> isolate_roots(const IntegerPolynomial& p);

/// Narrows the interval around a simple root until it is at most 2^-bits wide, or the root is found: guesses by the
/// secant get twice the bits each time they are right ([Abbott 2014]).
void refine(const IntegerPolynomial& p, RootInterval& root, unsigned long bits);

}  // namespace bezierbench::reference
