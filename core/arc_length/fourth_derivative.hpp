// SPDX-License-Identifier: MIT
// A bound of the fourth derivative of the speed f = |h| over a panel, from the control vectors of h.
//
// Derived in docs/proofs/fourth_derivative.md, from bounds of the derivatives of h and a lower bound of |h|.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "core/arc_length/panel.hpp"
#include "core/curve.hpp"

namespace bezierbench {

/// A bound of |f''''| on [0, 1] for the speed f; infinite where no positive lower bound of |h| is known.
struct FourthDerivative {
  double bound = std::numeric_limits<double>::infinity();
  /// The part of the bound that comes from roundings, which remains when panels are halved.
  double rounding = 0;
};

namespace detail {

/// A lower bound of |h| on [0, 1], trivial where it is 0 or less.
template <int Dimension, int Degree>
double min_size(const Curve<Form::bernstein, double, Dimension, Degree>& h) {
  std::array<double, Dimension> mean{};
  for (int i = 0; i <= h.degree(); ++i)
    for (std::size_t axis = 0; axis < Dimension; ++axis) mean[axis] += h(static_cast<int>(axis), i);
  double square = 0;
  for (const double x : mean) square += x * x;
  if (square == 0) return 0;
  double least = std::numeric_limits<double>::infinity();
  for (int i = 0; i <= h.degree(); ++i) {
    double along = 0;
    for (std::size_t axis = 0; axis < Dimension; ++axis) along += h(static_cast<int>(axis), i) * mean[axis];
    least = std::min(least, along);
  }
  return least / std::sqrt(square);
}

}  // namespace detail

template <int Dimension, int Degree>
FourthDerivative fourth_derivative(const Curve<Form::bernstein, double, Dimension, Degree>& h) {
  constexpr double u = 0x1p-53;
  const int m = h.degree();
  const double longest = longest_vector(h);
  const double least = detail::min_size(h) - 4 * Dimension * u * longest;
  if (!(least > 0)) return {};
  std::array<double, 5> derivatives{};  // largest sizes of h and its derivatives
  FourthDerivative result;
  double factor = 1;
  auto differences = h;
  for (int k = 1; k <= std::min(m, 4); ++k) {
    for (int i = 0; i <= m - k; ++i)
      for (int axis = 0; axis < Dimension; ++axis)
        differences(axis, i) = differences(axis, i + 1) - differences(axis, i);
    factor *= m - k + 1;
    const double rounding = factor * k * std::ldexp(u, k) * Dimension * longest;
    derivatives[static_cast<std::size_t>(k)] = factor * longest_vector(differences, m - k) + rounding;
    result.rounding = rounding;
  }
  const auto [unused, v, a, j, s] = derivatives;
  const double second = v * v / least + a;
  const double third = 3 * v * (a + second) / least + j;
  result.bound = (4 * v * (j + third) + 3 * second * second) / least + s;
  return result;
}

}  // namespace bezierbench
