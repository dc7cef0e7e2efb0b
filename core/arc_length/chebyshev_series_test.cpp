// SPDX-License-Identifier: MIT
// The series of Chebyshev polynomials, whose control points are known, have one term.
#include "core/arc_length/chebyshev_series.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "core/arc_length/fixed_degree.hpp"
#include "core/evaluate/kernel/kernel_of.hpp"

namespace bezierbench {
namespace {

/// The control points of T_n(2t - 1): (-1)^(n-i) C(2n, 2i) / C(n, i) ([Rababah 2003]).
/// With t = cos^2 v, T_n(2t - 1) = cos 2nv is the real part of (cos v + i sin v)^(2n).
std::vector<double> control_points(int n) {
  std::vector<double> points{n % 2 == 0 ? 1.0 : -1.0};
  for (int i = 1; i <= n; ++i) points.push_back(-points.back() * (2 * (n - i) + 1) / (2 * i - 1));
  return points;
}

TEST(ChebyshevSeries, OfAChebyshevPolynomialIsItself) {
  for (int n = 1; n <= 40; ++n) {
    const auto points = control_points(n);
    const auto curve = instantiate::load<Form::bernstein, 1>(CurveView<double>{Form::bernstein, 1, n, points});
    const double largest = std::ranges::max(points);
    ChebyshevSeries<1> series(n);
    with_fixed_degree(curve, [&](const auto& fixed) { series.expand(fixed, largest); });
    const auto of_fixed = series;
    series.expand(curve, largest);
    for (std::size_t k = 0; k <= series.degree(); ++k) EXPECT_EQ(series.size(k), of_fixed.size(k)) << n << " " << k;
    const double rounding = series.rounding(largest);
    const bool is_cut = n > static_cast<int>(series.degree_limit);
    if (is_cut) {
      EXPECT_GE(series.cut(), 1) << n;  // the distance of T_n from any polynomial of lower degree
      continue;
    }
    EXPECT_EQ(series.cut(), rounding) << n;
    for (std::size_t k = 0; k <= series.degree(); ++k)
      EXPECT_NEAR(series.size(k), k == static_cast<std::size_t>(n) ? 1 : 0, rounding) << n << " " << k;
  }
}

/// The size of a term and the cut include every axis. One series serves many curves.
TEST(ChebyshevSeries, CombinesAxes) {
  ChebyshevSeries<3> series(5);
  Curve<Form::bernstein, double, 3> curve(5);
  const auto points = control_points(5);
  for (const double scale : {1.0, 0.5}) {
    for (int i = 0; i <= 5; ++i) {
      curve(0, i) = 3 * scale * points[static_cast<std::size_t>(i)];
      curve(1, i) = 4 * scale * points[static_cast<std::size_t>(i)];
      curve(2, i) = 7 * scale;
    }
    series.expand(curve, 100);
    const double rounding = series.rounding(100);
    EXPECT_NEAR(series.size(0), 7 * scale, rounding);
    EXPECT_NEAR(series.size(5), 5 * scale, rounding);
    for (const std::size_t k : {1U, 2U, 3U, 4U}) EXPECT_LE(series.size(k), rounding);
    series.shorten(4.9 * scale);
    EXPECT_EQ(series.degree(), 5);
    series.shorten(5.1 * scale);
    EXPECT_EQ(series.degree(), 0);
    EXPECT_NEAR(series.cut(), 5 * scale, 10 * rounding);
  }
}

}  // namespace
}  // namespace bezierbench
