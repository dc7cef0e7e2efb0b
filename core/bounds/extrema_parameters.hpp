// SPDX-License-Identifier: MIT
// The parameters of the extrema of one axis, in floating point: roots of the derivative, or of a rational curve of its
// numerator N'W - NW', with N = sum w_i b_i B_i and W = sum w_i B_i. A polynomial in Bernstein form is halved until its
// coefficients change their sign once, then its root is bisected; pieces without a change have no root.
//
// Source: [Lane and Riesenfeld 1981], roots by subdivision and sign changes; [Farouki and Rajan 1988], the product.
#pragma once

#include <utility>
#include <vector>

#include "core/binomial.hpp"
#include "core/bounds/bounds.hpp"

namespace bezierbench {

/// The value at t of the polynomial with these Bernstein coefficients, by de Casteljau.
inline double bernstein_value(std::vector<double> b, double t) {
  for (std::size_t k = b.size() - 1; k > 0; --k)
    for (std::size_t i = 0; i < k; ++i) b[i] = (1 - t) * b[i] + t * b[i + 1];
  return b[0];
}

/// The halves of this polynomial over [0, 1/2] and [1/2, 1]; midpoints cannot overflow.
inline std::pair<std::vector<double>, std::vector<double>> bernstein_halves(std::vector<double> b) {
  std::vector<double> left{b[0]};
  for (std::size_t k = b.size() - 1; k > 0; --k) {
    for (std::size_t i = 0; i < k; ++i) b[i] = b[i] / 2 + b[i + 1] / 2;
    left.push_back(b[0]);
  }
  return {std::move(left), std::move(b)};
}

namespace detail {

inline int sign_changes(const std::vector<double>& b) {
  int changes = 0;
  double last = 0;
  for (const double x : b) {
    if (x == 0) continue;
    changes += last != 0 && (x < 0) != (last < 0) ? 1 : 0;
    last = x;
  }
  return changes;
}

/// Calls take(t) in ascending order for the roots in (low, low + width), b being the coefficients there.
template <class Take>
void each_root(const std::vector<double>& b, double low, double width, const Take& take) {
  constexpr double narrowest = 0x1p-53;
  const int changes = sign_changes(b);
  if (changes == 0) return;
  if (width <= narrowest) return take(low + width / 2);
  if (changes > 1) {
    const auto [left, right] = bernstein_halves(b);
    each_root(left, low, width / 2, take);
    if (right[0] == 0) take(low + width / 2);
    return each_root(right, low + width / 2, width / 2, take);
  }
  double from = 0;
  double to = 1;
  const bool rises = [&] {
    for (const double x : b)
      if (x != 0) return x < 0;
    return false;
  }();
  while ((to - from) * width > narrowest) {
    const double middle = from / 2 + to / 2;
    const double value = bernstein_value(b, middle);
    if (value == 0) from = to = middle;
    ((value < 0) == rises ? from : to) = middle;
  }
  take(low + (from / 2 + to / 2) * width);
}

}  // namespace detail

/// Calls take(t) in ascending order for the parameters in (0, 1) of extrema of a polynomial axis.
template <class Take>
void each_extremum(const PolynomialAxis& axis, const Take& take) {
  std::vector<double> slope;
  for (int i = 0; i < axis.degree(); ++i) slope.push_back(axis(0, i + 1) / 2 - axis(0, i) / 2);
  if (!slope.empty()) detail::each_root(slope, 0, 1, take);
}

/// Likewise of a rational one, of degree up to 500: C(2n-1, k) stays finite.
template <class Take>
void each_extremum(const RationalAxis& axis, const Take& take) {
  const int n = axis.degree();
  const BinomialRow<double, dynamic> below(n > 0 ? n - 1 : 0);
  const BinomialRow<double, dynamic> here(n);
  const BinomialRow<double, dynamic> product(n > 0 ? 2 * n - 1 : 0);
  const auto numerator = [&](int i) { return axis.weights[i] * axis.points(0, i); };
  std::vector<double> slope;
  for (int k = 0; k < 2 * n; ++k) {
    double sum = 0;
    for (int i = k < n ? 0 : k - n; i < n && i <= k; ++i) {
      const int j = k - i;
      const double cross =
          (numerator(i + 1) - numerator(i)) * axis.weights[j] - numerator(j) * (axis.weights[i + 1] - axis.weights[i]);
      sum += cross * (below[i] / product[k] * here[j]);
    }
    slope.push_back(sum);
  }
  if (!slope.empty()) detail::each_root(slope, 0, 1, take);
}

}  // namespace bezierbench
