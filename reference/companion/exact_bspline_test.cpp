// SPDX-License-Identifier: MIT
// The exact values of B-spline curves. Over any knots, the control points of t^n are the products of n neighbouring
// knots (Marsden's identity), and those of t their means.
#include "reference/companion/exact_bspline.hpp"

#include <gtest/gtest.h>

#include <vector>

#include "reference/rational_test.hpp"

namespace bezierbench::reference {
namespace {

using Numbers = std::vector<double>;

/// Products of n neighbours; exact for the knots below.
Numbers products(const Numbers& knots) {
  const std::size_t n = knots.size() / 2;
  Numbers all;
  for (std::size_t i = 0; i <= n; ++i) {
    all.push_back(1);
    for (std::size_t k = 0; k < n; ++k) all.back() *= knots[i + k];
  }
  return all;
}

Rational power(double t, std::size_t n) {
  Rational product = exactly(1.0);
  for (std::size_t k = 0; k < n; ++k) product = product * exactly(t);
  return product;
}

const std::vector<Numbers> some_knots{{2, 5}, {0, 1, 2, 3}, {1, 1, 1, 2, 4, 7}, {-3, -1, 2, 2.5, 3, 3, 3, 9}};

TEST(ExactBspline, ReturnsPowersOfT) {
  for (const auto& knots : some_knots) {
    const std::size_t n = knots.size() / 2;
    for (const double t : {knots[n - 1], 0.75 * knots[n - 1] + 0.25 * knots[n], knots[n]})
      EXPECT_TRUE(same(ExactBsplineWeights::at(knots, t).sum(1, products(knots)).coordinate(0), power(t, n)))
          << n << " t " << t;
  }
}

TEST(ExactBspline, ControlPointsAreValuesAtTheEndsOfTheSpan) {
  for (const auto& knots : some_knots) {
    const std::size_t n = knots.size() / 2;
    for (std::size_t k = 0; k <= n; ++k) {
      const auto weights = ExactBsplineWeights::of_control_point(knots, static_cast<int>(k));
      EXPECT_TRUE(same(weights.sum(1, products(knots)).coordinate(0), power(knots[n - 1], n - k) * power(knots[n], k)))
          << n << " control point " << k;
    }
  }
}

/// The quarter circle with weights 1, 1, 2, which is exact; its knots could be those of any clamped span.
TEST(ExactBspline, WeightsMakeACircle) {
  const Numbers weights{1, 1, 2};
  for (const double t : {0.0, 0.1, 0.5, 0.7, 1.0}) {
    const auto basis = ExactBsplineWeights::at(Numbers{0, 0, 1, 1}, t);
    const auto point = basis.with(weights).sum(2, Numbers{1, 0, 1, 1, 0, 1});
    EXPECT_TRUE(
        same(point.coordinate(0) * point.coordinate(0) + point.coordinate(1) * point.coordinate(1), exactly(1.0)))
        << t;
    EXPECT_TRUE(same(basis.with(Numbers{3, 3, 3}).sum(1, weights).coordinate(0), basis.sum(1, weights).coordinate(0)));
  }
}

/// Thirds, which no double is: the uniform quadratic's knots 0, 1, 3, 4 have N_0(1) = 2/3.
TEST(ExactBspline, HasFractions) {
  const auto point = ExactBsplineWeights::at(Numbers{0, 1, 3, 4}, 1).sum(2, Numbers{1, 0, 0, 1, 0, 0});
  EXPECT_TRUE(same(point.coordinate(0) * exactly(3.0), exactly(2.0)));
  EXPECT_TRUE(same(point.coordinate(1) * exactly(3.0), exactly(1.0)));
}

}  // namespace
}  // namespace bezierbench::reference
