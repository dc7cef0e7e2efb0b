// SPDX-License-Identifier: MIT
// The sums that forward error bounds multiply, evaluated in double. All terms are positive, so the relative error is a
// few n u.
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
//   p~, centred form       sum c_j z^j with z = |t - 1/2|
//   Bernstein -> centred   q_j = C(n,j) M^(n-j) D^j b_0 with midpoints M = (1 + E)/2 and differences D = E - 1 (E moves
//                          to the next control point), so |q_j| <= C(n,j) M^(n-j) (1 + E)^j c_0 = C(n,j) 2^j M^n c_0;
//                          summing over j with z^j leaves (1 + 2z)^n M^n c_0 = (1/2 + z)^n sum c_i C(n,i)
// For rational curves c_i stands for |w_i b_i|, and p~ is the sum for the Bernstein form over |sum w_i B_i(t)|.
#pragma once

#include <algorithm>
#include <cmath>
#include <span>

#include "core/basis/error_bound.hpp"
#include "core/basis/integer_power.hpp"
#include "core/basis/scaled.hpp"
#include "core/curve_view.hpp"

namespace bezierbench {

namespace detail {

constexpr int safe_exponent = 400;

/// True where |value| is 0 or within 2^-400 .. 2^400.
inline bool is_moderate(double value) { return value == 0 || (value > 0x1p-400 && value < 0x1p+400); }

inline bool are_moderate(std::span<const double> values) { return std::ranges::all_of(values, is_moderate); }

/// True where no power up to value^n leaves 2^-400 .. 2^400 (or value is 0).
inline bool has_moderate_powers(double value, int n) {
  if (value == 0) return true;
  int exponent = 0;
  std::frexp(value, &exponent);
  return (std::abs(exponent) + 1) * n < safe_exponent;
}

/// Both sums below, in arithmetic that can neither overflow nor underflow on the way.
inline double scaled_sum(std::span<const double> c, double x, double y, bool with_binomials) {
  const int n = static_cast<int>(c.size()) - 1;
  // Horner's scheme in x, the powers of y and the binomials running: sum = (...(c_n x + w_1 c_(n-1)) x + ...).
  Scaled sum(c[static_cast<std::size_t>(n)]);
  Scaled weight(1);
  for (int i = n - 1; i >= 0; --i) {
    weight = weight * Scaled(y);
    if (with_binomials) weight = weight * Scaled(static_cast<double>(i + 1) / (n - i));
    sum = sum * Scaled(x) + weight * Scaled(c[static_cast<std::size_t>(i)]);
  }
  return sum.to_double();
}

}  // namespace detail

/// sum c_i C(n,i) x^i y^(n-i) for c >= 0 and x, y >= 0 with x + y >= 1. Right to a few n u wherever it is a normal
/// number.
inline double bernstein_sum(std::span<const double> c, double x, double y) {
  const int n = static_cast<int>(c.size()) - 1;
  const bool ascending = x <= y;  // factor out the larger of x^n, y^n: the ratio is at most 1
  const double larger = ascending ? y : x;
  const double ratio = (ascending ? x : y) / larger;
  const bool moderate = n < detail::safe_exponent && detail::has_moderate_powers(larger, n) &&
                        detail::has_moderate_powers(ratio, n) && detail::are_moderate(c);
  if (!moderate) return detail::scaled_sum(c, x, y, true);
  double weight = 1;
  double sum = 0;
  for (int i = 0; i <= n; ++i) {
    if (i > 0) weight = weight * ratio * (n - i + 1) / i;
    sum += weight * c[static_cast<std::size_t>(ascending ? i : n - i)];
  }
  return sum * integer_power(larger, n);
}

/// sum c_j x^j y^(n-j) for c, x, y >= 0. Right to a few n u wherever it is a normal number.
inline double power_sum_of(std::span<const double> c, double x, double y) {
  const int n = static_cast<int>(c.size()) - 1;
  if (!detail::has_moderate_powers(x, n) || !detail::has_moderate_powers(y, n) || !detail::are_moderate(c))
    return detail::scaled_sum(c, x, y, false);
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
  const double z = std::abs(t - 0.5);
  switch (kind) {
    case Amplification::p_tilde_bernstein: return bernstein_sum(c, x, y);
    case Amplification::p_tilde_power: return power_sum_of(c, x, 1);
    case Amplification::bernstein_to_power: return bernstein_sum(c, x, 1 + x);
    case Amplification::power_to_bernstein: return power_sum_of(c, x, x + y);
    case Amplification::forward_substitution: return power_sum_of(c, x, 3 * x + y);
    case Amplification::p_tilde_centered: return power_sum_of(c, z, 1);
    case Amplification::bernstein_to_centered: return bernstein_sum(c, 0.5 + z, 0.5 + z);
  }
  return 0;
}

/// The amplification that the definition of p~ uses for a form.
constexpr Amplification p_tilde_of(Form form) {
  switch (form) {
    case Form::bernstein:
    case Form::rational: return Amplification::p_tilde_bernstein;
    case Form::power_centered: return Amplification::p_tilde_centered;
    case Form::power:
    case Form::power_double_double: break;
  }
  return Amplification::p_tilde_power;
}

}  // namespace bezierbench
