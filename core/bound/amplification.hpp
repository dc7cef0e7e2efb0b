// SPDX-License-Identifier: MIT
// The sums that forward error bounds multiply, evaluated in double. All terms are positive, so the relative error is a
// few n u.
//
// With x = |t| and y = |1 - t|, and c >= 0 standing for |coefficient|:
//   p~, Bernstein form     sum c_i C(n,i) x^i y^(n-i)
//   p~, power form         sum c_j x^j
//   Bernstein -> power     sum c_i C(n,i) x^i (1+x)^(n-i)
//   power -> Bernstein     sum c_j x^j (x+y)^(n-j)
//   forward substitution   sum c_j x^j (3x+y)^(n-j)
//   p~, centred form       sum c_j z^j with z = |t - 1/2|
//   Bernstein -> centred   (1/2 + z)^n sum c_i C(n,i)
// The three kinds of `spread` are sums of this table whose c_i stands for |b_i - b|, with b an end of the curve.
// For rational curves c_i stands for |w_i b_i|, and p~ is the sum for the Bernstein form over |sum w_i B_i(t)|.
// docs/proofs/amplification.md derives them.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <span>

#include "core/bound/error_bound.hpp"
#include "core/bound/scaled.hpp"
#include "core/curve_view.hpp"
#include "core/powers.hpp"
#include "core/vector/lane_choice.hpp"

namespace bezierbench {

namespace detail {

constexpr int safe_exponent = 400;

/// True where a value >= 0 is 0 or within 2^-400 .. 2^400.
template <class Real>
auto is_moderate(const Real& value) {
  return either(value <= Real(0), both(Real(0x1p-400) < value, value < Real(0x1p+400)));
}

/// True where no power up to value^n of a value >= 0 leaves 2^-400 .. 2^400 (or value is 0).
template <class Real>
auto has_moderate_powers(const Real& value, int n) {
  const int most = (safe_exponent - 1) / std::max(n, 1);  // value in [2^(e-1), 2^e) must have |e| < most
  return either(value <= Real(0), both(Real(std::ldexp(1.0, -most)) <= value, value < Real(std::ldexp(1.0, most - 1))));
}

/// Both sums below, in arithmetic that can neither overflow nor underflow on the way.
template <class Coefficient>
double scaled_sum(int n, const Coefficient& c, double x, double y, bool with_binomials) {
  // Horner's scheme in x, the powers of y and the binomials running: sum = (...(c_n x + w_1 c_(n-1)) x + ...).
  Scaled sum(c(n));
  Scaled weight(1);
  for (int i = n - 1; i >= 0; --i) {
    weight = weight * Scaled(y);
    if (with_binomials) weight = weight * Scaled(static_cast<double>(i + 1) / (n - i));
    sum = sum * Scaled(x) + weight * Scaled(c(i));
  }
  return sum.to_double();
}

/// `sum` where it is moderate, else the same in scaled arithmetic.
template <class Real, class Mask, class Coefficient>
Real moderate_or_scaled(const Mask& moderate, const Real& sum, int n, const Coefficient& c, const Real& x,
                        const Real& y, bool with_binomials) {
  return value_or(moderate, sum, [&](std::size_t lane) {
    const auto coefficient = [&](int i) { return lane_of(c(i), lane); };
    return scaled_sum(n, coefficient, lane_of(x, lane), lane_of(y, lane), with_binomials);
  });
}

}  // namespace detail

/// sum c_i C(n,i) x^i y^(n-i) for c(i) >= 0 and x, y >= 0 with x + y >= 1. Right to a few n u wherever it is a normal
/// number.
template <class Real, class Coefficient>
Real bernstein_sum(int n, const Coefficient& c, const Real& x, const Real& y) {
  const auto ascending = x <= y;  // factor out the larger of x^n, y^n: the ratio is at most 1
  const Real larger = select(ascending, y, x);
  const Real ratio = select(ascending, x, y) / larger;
  auto moderate = both(detail::has_moderate_powers(larger, n), detail::has_moderate_powers(ratio, n));
  Real weight(1);
  Real sum(0);
  for (int i = 0; i <= n; ++i) {
    if (i > 0) weight = weight * ratio * Real(n - i + 1) / Real(i);
    const Real coefficient = select(ascending, c(i), c(n - i));
    moderate = both(moderate, detail::is_moderate(coefficient));
    sum += weight * coefficient;
  }
  return detail::moderate_or_scaled<Real>(moderate, sum * integer_power(larger, n), n, c, x, y, true);
}

/// sum c_j x^j y^(n-j) for c(j), x, y >= 0. Right to a few n u wherever it is a normal number.
template <class Real, class Coefficient>
Real power_sum_of(int n, const Coefficient& c, const Real& x, const Real& y) {
  auto moderate = both(detail::has_moderate_powers(x, n), detail::has_moderate_powers(y, n));
  Real sum = c(n);
  moderate = both(moderate, detail::is_moderate(sum));
  Real y_power(1);
  for (int j = n - 1; j >= 0; --j) {
    const Real coefficient = c(j);
    moderate = both(moderate, detail::is_moderate(coefficient));
    y_power *= y;
    sum = sum * x + coefficient * y_power;
  }
  return detail::moderate_or_scaled<Real>(moderate, sum, n, c, x, y, false);
}

/// The amplification at t of the n+1 coefficients whose magnitudes are c(0), ..., c(n), counted from the anchor of the
/// kind. `Real` is double, or many lanes with a curve and a t in each; every lane has the bits of the double.
template <class Real, class Coefficient>
Real amplification(Amplification kind, int n, const Coefficient& c, const Real& t) {
  using std::abs;
  const Real one(1);
  const Real half(0.5);
  const Real x = abs(t);
  const Real y = abs(one - t);
  const Real z = abs(t - half);
  switch (kind) {
    case Amplification::p_tilde_bernstein: return bernstein_sum(n, c, x, y);
    case Amplification::p_tilde_power: return power_sum_of(n, c, x, one);
    case Amplification::bernstein_to_power: return bernstein_sum<Real>(n, c, x, one + x);
    case Amplification::power_to_bernstein: return power_sum_of<Real>(n, c, x, x + y);
    case Amplification::forward_substitution: return power_sum_of<Real>(n, c, x, Real(3) * x + y);
    case Amplification::p_tilde_centered: return power_sum_of(n, c, z, one);
    case Amplification::bernstein_to_centered: return bernstein_sum<Real>(n, c, half + z, half + z);
    case Amplification::spread: return bernstein_sum(n, c, x, y);
    case Amplification::spread_to_power: {
      const auto near_start = t + t <= one;
      return bernstein_sum<Real>(n, c, select(near_start, x, one + y), select(near_start, one + x, y));
    }
    case Amplification::spread_to_power_from_start: return bernstein_sum<Real>(n, c, x, one + x);
  }
  return Real(0);
}

inline double amplification(Amplification kind, std::span<const double> c, double t) {
  return amplification(
      kind, static_cast<int>(c.size()) - 1, [c](int i) { return c[static_cast<std::size_t>(i)]; }, t);
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
