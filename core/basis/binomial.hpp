// SPDX-License-Identifier: MIT
// C(n,i) for one n and all i, by C(n,i) = C(n,i-1) (n-i+1) / i and symmetry.
//
// Exact in double for n <= 54 (verified for every entry in the tests), although products pass 2^53 from n = 52 on;
// beyond that each of the at most n/2 steps rounds twice. `binomial_roundings` counts them for the error bounds.
#pragma once

#include "core/basis/shared.hpp"
#include "core/curve.hpp"

namespace bezierbench {

/// A power of two that keeps C(n,i) (n - i + 1) finite: the recurrence runs on C(n,i) / binomial_scale(n).
constexpr double binomial_scale(int n) { return n > 1000 ? 0x1p+20 : 1; }

/// The row C(n,0..n), formed in double and rounded once to Scalar.
template <class Scalar, int Degree>
PerCoefficient<SharedBy<Scalar>, Degree> binomials(int n) {
  auto row = per_coefficient<SharedBy<Scalar>, Degree>(n);
  const double scale = binomial_scale(n);
  double value = 1 / scale;
  for (int i = 0; 2 * i <= n; ++i) {
    if (i > 0) value = value * (n - i + 1) / i;
    row[i] = static_cast<SharedBy<Scalar>>(value * scale);
    row[n - i] = row[i];
  }
  return row;
}

/// C(n, n/2), the largest C(n,i), to within n roundings.
constexpr double central_binomial(int n) {
  double value = 1;
  for (int i = 1; 2 * i <= n; ++i) value *= static_cast<double>(n - i + 1) / i;
  return value;
}

/// Largest n for which `binomials<double>` is exact.
inline constexpr int exact_binomial_degree = 54;

/// The largest number of roundings in any C(n,i): those of the recurrence, and the one to float.
constexpr double binomial_roundings(int n, double u) {
  return (n > exact_binomial_degree ? n : 0) + (u > 0x1p-53 ? 1 : 0);
}

}  // namespace bezierbench
