// SPDX-License-Identifier: MIT
// 0!, 1!, ..., n! by running product, as [Report 001], section 1.4, tabulates them.
//
// In double they are exact through 22! and finite through 170!; in float exact through 13! and finite through 34!.
#pragma once

#include "core/curve.hpp"
#include "core/vector/shared.hpp"

namespace bezierbench {

inline constexpr int max_factorial = 170;
inline constexpr int max_factorial_float = 34;

/// The factorials 0! .. n! in Scalar; finite for n up to max_factorial (max_factorial_float).
template <class Scalar, int Degree>
PerCoefficient<SharedBy<Scalar>, Degree> factorials(int n) {
  using Shared = SharedBy<Scalar>;
  auto row = per_coefficient<Shared, Degree>(n);
  row[0] = Shared(1);
  for (int k = 1; k <= n; ++k) row[k] = row[k - 1] * static_cast<Shared>(k);
  return row;
}

/// The largest number of roundings in any of 0! .. n!.
constexpr double factorial_roundings(int n, double u) {
  const int exact_through = u > 0x1p-53 ? 13 : 22;
  return n > exact_through ? n - exact_through : 0;
}

/// (n)_k = n (n-1) ... (n-k+1), the factor that k derivatives bring; 1 for k = 0, and 0 for k > n. At most k - 1
/// roundings, none while it stays below 2^53.
constexpr double falling_factorial(int n, int k) {
  double product = 1;
  for (int m = 0; m < k && product != 0; ++m) product *= n - m;
  return product;
}

}  // namespace bezierbench
