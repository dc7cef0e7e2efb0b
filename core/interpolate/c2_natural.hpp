// SPDX-License-Identifier: MIT
// Formula: the C2 natural cubic spline by its slopes D_i, a third of the derivative at K_i, refined once:
//   P1,i = K_i + D_i,  P2,i = K_(i+1) - D_(i+1),  so that C1 needs no equation; C2 and natural ends are
//   D_(i-1) + 4 D_i + D_(i+1) = K_(i+1) - K_(i-1),  2 D_0 + D_1 = K_1 - K_0,  D_(n-1) + 2 D_n = K_n - K_(n-1).
//   The residuals of this system are summed with their rounding errors and solved for a correction, which is added to
//   K_i and D_i before these are rounded to a control point.
// Cost: all but 7 of the 90 flops belong to the refinement.
// Bound: each control point is the exact one rounded once, up to terms of u^2; |P| <= sqrt(3) max|K|. The residuals
//   that these roundings leave are at most 2 u max|K| in C1, (P1,i - K_i) - (K_i - P2,i-1); (14 - 4 sqrt(3)) u max|K|
//   in C2, the second differences of two segments; and 4.24 u max|K| at an end; each plus 3 times the smallest double
//   (residual_underflow). Without refinement 10 u max|K| was observed.
// Fails: control points beyond the largest double are infinite.
#pragma once

#include <initializer_list>

#include "core/error_free.hpp"
#include "core/interpolate/interpolation.hpp"

namespace bezierbench {

struct C2Natural {
  static constexpr MethodInfo info{
      .id = "c2_natural",
      .label = "C2 natural spline by its slopes, refined",
      .problem = Problem::interpolation,
      .form = Form::bernstein,
      .min_degree = 3,
      .max_degree = 3,
      .promise =
          "C1, C2 and natural ends to 7.1 u times the largest coordinate plus 3 times the smallest double, proved",
      .flops = "per point 90d",
      .citation = "[de Boor 1978], chapter IV; [Higham 2002], section 12.1"};

  static constexpr double residual_bound = 7.1;  ///< 14 - 4 sqrt(3) = 7.0718, and terms of u^2

  static InnerPoints inner_points(std::span<const double> k) {
    const std::size_t n = k.size() - 1;
    auto slopes = differences(k);
    spline_system::solve(slopes, 2);
    auto corrections = residuals(k, slopes);
    spline_system::solve(corrections, 2);
    InnerPoints points{std::vector<double>(n), std::vector<double>(n)};
    for (std::size_t i = 0; i < n; ++i) {
      points.first[i] = sum({k[i], slopes[i], corrections[i]});
      points.second[i] = sum({k[i + 1], -slopes[i + 1], -corrections[i + 1]});
    }
    return points;
  }

 private:
  static std::vector<double> differences(std::span<const double> k) {
    const std::size_t n = k.size() - 1;
    std::vector<double> right(n + 1);
    right[0] = k[1] - k[0];
    for (std::size_t i = 1; i < n; ++i) right[i] = k[i + 1] - k[i - 1];
    right[n] = k[n] - k[n - 1];
    return right;
  }

  static std::vector<double> residuals(std::span<const double> k, std::span<const double> d) {
    const std::size_t n = k.size() - 1;
    std::vector<double> left_over(n + 1);
    left_over[0] = sum({k[1], -k[0], -2 * d[0], -d[1]});
    for (std::size_t i = 1; i < n; ++i) left_over[i] = sum({k[i + 1], -k[i - 1], -4 * d[i], -d[i - 1], -d[i + 1]});
    left_over[n] = sum({k[n], -k[n - 1], -2 * d[n], -d[n - 1]});
    return left_over;
  }

  /// A sum as accurate as in twice the precision, then rounded once ([Ogita et al. 2005], Algorithm 4.4).
  static double sum(std::initializer_list<double> terms) {
    double value = 0;
    double error = 0;
    for (const double term : terms) {
      const auto next = two_sum(value, term);
      value = next.value;
      error += next.error;
    }
    return value + error;
  }
};

}  // namespace bezierbench
