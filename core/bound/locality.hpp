// SPDX-License-Identifier: MIT
// How large the power coefficients of a curve about its ends are beside its coordinates, by which a method may choose
// on each axis.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>

#include "core/bound/error_bound.hpp"
#include "core/curve_view.hpp"

namespace bezierbench {

/// A curve is local on an axis where this, as a method computes it, is at most 2.
inline constexpr double most_local = 2;

/// On one axis: sum_(j>0) |q_j| 2^-j / max|b_i|, with q_j the power coefficients about b_0 or about b_n, of which the
/// larger sum counts; 0 where all b_i are 0. b(i) is the coordinate of control point i.
template <class Coordinate>
double locality(int degree, const Coordinate& b) {
  std::array<double, max_degree + 1> difference;
  double largest = 0;
  for (int i = 0; i <= degree; ++i) {
    difference[static_cast<std::size_t>(i)] = b(i);
    largest = std::max(largest, std::abs(b(i)));
  }
  if (largest == 0) return 0;
  double from_start = 0;
  double from_end = 0;
  double weight = 1;
  for (int j = 1; j <= degree; ++j) {
    const auto last = static_cast<std::size_t>(degree - j);
    for (std::size_t i = 0; i <= last; ++i) difference[i] = difference[i + 1] - difference[i];
    weight *= 0.5 * (degree - j + 1) / j;  // C(n,j) 2^-j
    from_start += weight * std::abs(difference[0]);
    from_end += weight * std::abs(difference[last]);
  }
  return std::max(from_start, from_end) / largest;
}

/// How far a locality that is computed with unit roundoff u may be from the true one.
inline double locality_error(int degree, double u) {
  return 8 * gamma_over_u(4.0 * degree + 4, u) * u * std::ldexp(1.0, degree);
}

/// Which bounds may hold on some axis of a curve: that of local curves, that of the other ones. The error on all axes
/// together is at most the sum of those that do.
struct LocalOrNot {
  bool may_be_local = false;
  bool may_be_other = false;

  /// Takes the locality of one more axis.
  void add(double locality, int degree, double u) {
    const double error = locality_error(degree, u);
    may_be_local = may_be_local || !(locality > most_local + error);
    may_be_other = may_be_other || !(locality < most_local - error);
  }
};

}  // namespace bezierbench
