// SPDX-License-Identifier: MIT
// Roots of a polynomial in Bernstein form by subdivision: it is halved until its coefficients change their sign once,
// then its root is bisected; pieces without a change have no root.
//
// Source: [Lane and Riesenfeld 1981].
#pragma once

#include <cstdint>
#include <utility>
#include <vector>

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

/// How often the coefficients change their sign, zeros left out.
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

/// Roots in a piece of this width are not distinguished.
inline constexpr double narrowest_piece = 0x1p-53;

/// A root in local coordinates, and the number of values that it took.
struct BisectedRoot {
  double t;
  std::int64_t evaluations;
};

/// The root in (0, 1) of coefficients that change their sign once, of a piece of this width.
inline BisectedRoot bisected_root(const std::vector<double>& b, double width) {
  double from = 0;
  double to = 1;
  std::int64_t evaluations = 0;
  const bool rises = [&] {
    for (const double x : b)
      if (x != 0) return x < 0;
    return false;
  }();
  while ((to - from) * width > narrowest_piece) {
    const double middle = from / 2 + to / 2;
    const double value = bernstein_value(b, middle);
    ++evaluations;
    if (value == 0) from = to = middle;
    ((value < 0) == rises ? from : to) = middle;
  }
  return {from / 2 + to / 2, evaluations};
}

/// Calls take(t) in ascending order for the roots in (low, low + width), b being the coefficients there. Returns the
/// number of values and halvings.
template <class Take>
std::int64_t each_root_inside(const std::vector<double>& b, double low, double width, const Take& take) {
  const int changes = sign_changes(b);
  if (changes == 0) return 0;
  if (width <= narrowest_piece) {
    take(low + width / 2);
    return 0;
  }
  if (changes > 1) {
    const auto [left, right] = bernstein_halves(b);
    const auto before = each_root_inside(left, low, width / 2, take);
    if (right[0] == 0) take(low + width / 2);
    return 1 + before + each_root_inside(right, low + width / 2, width / 2, take);
  }
  const auto root = bisected_root(b, width);
  take(low + root.t * width);
  return root.evaluations;
}

}  // namespace bezierbench
