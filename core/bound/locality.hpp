// SPDX-License-Identifier: MIT
// How large the power coefficients of a curve about its ends are beside its coordinates, by which a method may choose.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>

#include "core/bound/error_bound.hpp"
#include "core/curve_view.hpp"

namespace bezierbench {

/// A curve is local where this, as a method computes it, is at most 2.
inline constexpr double most_local = 2;

/// With q_j the power coefficients about either end: the largest sum_(j>0) |q_j| 2^-j / max|b_i| over both ends and all
/// axes, 0 where all b_i are 0. coordinate(axis, i) is that of control point i.
template <class Coordinate>
double locality(int degree, int dimension, const Coordinate& coordinate) {
  double result = 0;
  std::array<double, max_degree + 1> difference;
  for (int axis = 0; axis < dimension; ++axis) {
    double largest = 0;
    double sums[2] = {0, 0};
    for (int i = 0; i <= degree; ++i) {
      difference[static_cast<std::size_t>(i)] = coordinate(axis, i);
      largest = std::max(largest, std::abs(coordinate(axis, i)));
    }
    double weight = 1;
    for (int j = 1; j <= degree; ++j) {
      for (std::size_t i = 0; i <= static_cast<std::size_t>(degree - j); ++i)
        difference[i] = difference[i + 1] - difference[i];
      weight *= 0.5 * (degree - j + 1) / j;  // C(n,j) 2^-j
      sums[0] += weight * std::abs(difference[0]);
      sums[1] += weight * std::abs(difference[static_cast<std::size_t>(degree - j)]);
    }
    if (largest > 0) result = std::max({result, sums[0] / largest, sums[1] / largest});
  }
  return result;
}

/// How far a locality that is computed with unit roundoff u, from coordinates up to 1, may be from the true one.
inline double locality_error(int degree, double u) {
  return 8 * gamma_over_u(4.0 * degree + 4, u) * u * std::ldexp(1.0, degree);
}

/// Whether a bound of curves that are local, and one of the others, may hold for a curve.
struct LocalOrNot {
  bool may_be_local;
  bool may_be_other;
};
inline LocalOrNot local_or_not(double locality, int degree, double u) {
  const double error = locality_error(degree, u);
  return {!(locality > most_local + error), !(locality < most_local - error)};
}

}  // namespace bezierbench
