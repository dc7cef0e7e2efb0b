// SPDX-License-Identifier: MIT
// Complex arithmetic for solvers of polynomials, with the same bits in every build: a library may divide and take
// absolute values in ways of its own, products are the same everywhere.
#pragma once

#include <cmath>
#include <complex>
#include <cstddef>
#include <vector>

#include "core/project/root_projection.hpp"

namespace bezierbench {

using Complex = std::complex<double>;

/// a b; the operator of std::complex would look for infinities in products that are not numbers.
inline Complex product(const Complex& a, const Complex& b) {
  return {a.real() * b.real() - a.imag() * b.imag(), a.real() * b.imag() + a.imag() * b.real()};
}

inline double magnitude(const Complex& z) { return std::sqrt(z.real() * z.real() + z.imag() * z.imag()); }

/// a / b, as a conj(b) / |b|^2.
inline Complex quotient(const Complex& a, const Complex& b) {
  const double square = b.real() * b.real() + b.imag() * b.imag();
  const Complex above = product(a, std::conj(b));
  return {above.real() / square, above.imag() / square};
}

/// Coefficients of 1, z, z^2, ...
using ComplexPolynomial = std::vector<Complex>;

/// A value, and whether it may consist of rounding errors only.
struct ComplexValue {
  Complex value;
  bool is_rounding = false;
};

/// p(z) by Horner's rule. A complex product errs by at most sqrt(5) u of itself and a sum by u, so that the value of a
/// polynomial of degree m errs by at most (sqrt(5) + 1) m u sum |p_j| |z|^j, up to terms of u^2; and within u |z| of a
/// root it is at most m u times that sum. 5 m u covers both.
inline ComplexValue value_at(const ComplexPolynomial& p, const Complex& z) {
  constexpr double u = 0x1p-53;
  const double size = magnitude(z);
  Complex value = p.back();
  double sum = magnitude(p.back());
  for (std::size_t j = p.size() - 1; j-- > 0;) {
    value = product(value, z) + p[j];
    sum = sum * size + magnitude(p[j]);
  }
  return {value, magnitude(value) <= 5 * static_cast<double>(p.size() - 1) * u * sum};
}

/// The real parts in [0, 1] of the roots, as companion_roots() has them.
inline std::vector<double> candidates_of(const std::vector<Complex>& roots) {
  std::vector<double> t;
  for (const auto& root : roots)
    if (root.real() >= 0 && root.real() <= 1) t.push_back(root.real());
  return t;
}

}  // namespace bezierbench
