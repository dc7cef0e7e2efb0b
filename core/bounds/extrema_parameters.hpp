// SPDX-License-Identifier: MIT
// The parameters of the extrema of one axis, in floating point: roots of the derivative, or of a rational curve of its
// numerator N'W - NW', with N = sum w_i b_i B_i and W = sum w_i B_i.
//
// Source: [Farouki and Rajan 1988], the product.
#pragma once

#include <vector>

#include "core/binomial.hpp"
#include "core/bounds/bounds.hpp"
#include "core/roots/subdivision.hpp"

namespace bezierbench {

/// Calls take(t) in ascending order for the parameters in (0, 1) of extrema of a polynomial axis.
template <class Take>
void each_extremum(const PolynomialAxis& axis, const Take& take) {
  std::vector<double> slope;
  for (int i = 0; i < axis.degree(); ++i) slope.push_back(axis(0, i + 1) / 2 - axis(0, i) / 2);
  if (!slope.empty()) each_root_inside(slope, 0, 1, take);
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
  if (!slope.empty()) each_root_inside(slope, 0, 1, take);
}

}  // namespace bezierbench
