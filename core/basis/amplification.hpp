// SPDX-License-Identifier: MIT
// The sums that forward error bounds multiply, evaluated in double with positive terms only, so to a few n u.
//
// With x = |t| and y = |1 - t|, and c >= 0 standing for |coefficient|:
//   p~, Bernstein form     sum c_i C(n,i) x^i y^(n-i)
//   p~, power form         sum c_j x^j
//   Bernstein -> power     |q_j| <= sum_i n!/(i!(n-j)!(j-i)!) c_i, and summing over j with x^j leaves
//                          sum c_i C(n,i) x^i (1+x)^(n-i); with c_i = max c this is (1+2x)^n max c
//   power -> Bernstein     b_i = sum_j C(i,j)/C(n,j) q_j has positive weights; summing over i with C(n,i) x^i y^(n-i)
//                          leaves sum c_j x^j (x+y)^(n-j)
//   forward substitution   L b = q is solved with an error of at most gamma |L^-1| |L| |b|. |L| maps Bernstein
//                          coefficients b to the power coefficients of sum b_i C(n,i) t^i (1+t)^(n-i), which is
//                          (1+2t)^n Q(t/(1+2t)) for Q the polynomial with coefficients c; so the sum becomes
//                          sum c_j x^j (3x+y)^(n-j), on [0,1] sum c_j t^j (1+2t)^(n-j)
#pragma once

#include <algorithm>
#include <cmath>
#include <span>

#include "core/basis/error_bound.hpp"
#include "core/curve.hpp"

namespace bezierbench {

/// base^exponent by repeated squaring; relative error at most about 2 exponent u.
constexpr double integer_power(double base, int exponent) {
  double result = 1;
  for (; exponent > 0; exponent /= 2, base *= base)
    if (exponent % 2 != 0) result *= base;
  return result;
}

/// sum c_i C(n,i) x^i y^(n-i) for c, x, y >= 0. Overflows or underflows only where the sum itself nearly does.
inline double bernstein_sum(std::span<const double> c, double x, double y) {
  const int n = static_cast<int>(c.size()) - 1;
  const bool ascending = x <= y;  // factor out the larger of x^n, y^n: the ratio is at most 1
  const double larger = ascending ? y : x;
  if (larger == 0) return n == 0 ? c[0] : 0;
  const double ratio = (ascending ? x : y) / larger;
  double largest = 0;
  for (const double value : c) largest = std::max(largest, value);
  int exponent = 0;
  std::frexp(largest, &exponent);
  const double scale = std::ldexp(1.0, -std::clamp(exponent, -1000, 1000));  // the largest coefficient becomes about 1
  const double first_weight = n > 500 ? 0x1p-60 : 1;  // leaves room for C(n,i) (n - i + 1) and for the sum
  double weight = first_weight;
  double sum = 0;
  for (int i = 0; i <= n; ++i) {
    if (i > 0) weight = weight * ratio * (n - i + 1) / i;
    sum += weight * (scale * c[static_cast<std::size_t>(ascending ? i : n - i)]);
  }
  return sum * integer_power(larger, n / 2) * integer_power(larger, n - n / 2) / scale / first_weight;
}

/// sum c_j x^j y^(n-j) for c, x, y >= 0.
inline double power_sum_of(std::span<const double> c, double x, double y) {
  const int n = static_cast<int>(c.size()) - 1;
  double sum = c[static_cast<std::size_t>(n)];
  double y_power = 1;
  for (int j = n - 1; j >= 0; --j) {
    y_power *= y;
    sum = sum * x + c[static_cast<std::size_t>(j)] * y_power;
  }
  return sum;
}

/// The amplification of the coefficients whose magnitudes are `c`, at t.
inline double amplification(Amplification kind, std::span<const double> c, double t) {
  const double x = std::abs(t);
  const double y = std::abs(1 - t);
  switch (kind) {
    case Amplification::p_tilde_bernstein: return bernstein_sum(c, x, y);
    case Amplification::p_tilde_power: return power_sum_of(c, x, 1);
    case Amplification::bernstein_to_power: return bernstein_sum(c, x, 1 + x);
    case Amplification::power_to_bernstein: return power_sum_of(c, x, x + y);
    case Amplification::forward_substitution: return power_sum_of(c, x, 3 * x + y);
  }
  return 0;
}

/// The amplification that the definition of p~ uses for a form.
constexpr Amplification p_tilde_of(Form form) {
  return form == Form::bernstein ? Amplification::p_tilde_bernstein : Amplification::p_tilde_power;
}

}  // namespace bezierbench
