// SPDX-License-Identifier: MIT
#include "reference/companion/interpolation.hpp"

#include <gtest/gtest.h>

#include <random>

namespace bezierbench::reference {
namespace {

void expect_equal(const Rational& value, long numerator, long denominator) {
  const Rational difference = value - Rational{numerator, denominator, 0};
  EXPECT_EQ(difference.numerator, 0) << "is not " << numerator << "/" << denominator << " but "
                                     << round_to(binary64, value);
}

void expect_points(const std::vector<Rational>& points, const std::vector<long>& numerators, long denominator) {
  ASSERT_EQ(points.size(), numerators.size());
  for (std::size_t i = 0; i < points.size(); ++i) expect_equal(points[i], numerators[i], denominator);
}

/// Worked by hand: 2 a + b = 2, a + 4 b + c = 4, 2 b + 7 c = 1 has the solution 5/9, 8/9, -1/9.
TEST(ExactSpline, OfZeroOneZeroOne) {
  const std::vector<double> k{0, 1, 0, 1};
  const auto spline = exact_spline(k);
  expect_points(spline.first, {5, 8, -1}, 9);
  expect_points(spline.second, {10, 1, 4}, 9);
}

/// One segment is straight; of two, 0, 1, 0 gives 2 a + b = 2, 2 a + 7 b = 8: a = 1/2, b = 1.
TEST(ExactSpline, OfOneAndTwoSegments) {
  expect_points(exact_spline(std::vector<double>{1, 7}).first, {3}, 1);
  expect_points(exact_spline(std::vector<double>{1, 7}).second, {5}, 1);
  const auto two = exact_spline(std::vector<double>{0, 1, 0});
  expect_points(two.first, {1, 2}, 2);
  expect_points(two.second, {2, 1}, 2);
}

/// The general definition gives the same spline at uniform parameters.
TEST(ExactSpline, OfTheGeneralSystemIsTheSame) {
  const std::vector<double> k{0.1, -7, 3, 3, 0x1p-60, 1e10};
  for (std::size_t n = 1; n < k.size(); ++n) {
    const auto points = std::span(k).first(n + 1);
    const auto expected = exact_spline(points);
    const auto spline = exact_spline(points, {std::vector<double>(n, 2.0)});
    for (std::size_t i = 0; i < n; ++i) {
      EXPECT_EQ((spline.first[i] - expected.first[i]).numerator, 0);
      EXPECT_EQ((spline.second[i] - expected.second[i]).numerator, 0);
    }
  }
}

/// By hand: t^2 at 0, 1, 3, whose blossom is (ab + ac + bc)/3; a Hermite cubic; and the closed spline through 0 and 1,
/// whose slopes vanish by symmetry.
TEST(ExactSpline, OfOtherEnds) {
  using Ends = SplineSystem::Ends;
  const std::vector<double> steps{1, 2};
  const auto square = exact_spline(std::vector<double>{0, 1, 9}, {steps, Ends::not_a_knot});
  expect_points(square.first, {0, 7}, 3);
  expect_points(square.second, {1, 15}, 3);
  const auto hermite = exact_spline(std::vector<double>{1, 2}, {std::vector<double>{7.0}, Ends::clamped, 6, -3});
  expect_points(hermite.first, {3}, 1);
  expect_points(hermite.second, {3}, 1);
  const auto closed = exact_spline(std::vector<double>{0, 1, 0}, {std::vector<double>{1, 1}, Ends::closed});
  expect_points(closed.first, {0, 1}, 1);
  expect_points(closed.second, {1, 0}, 1);
}

/// The printed back-substitution P2,i = 2 K_i - P1,i of [Document 003] leaves C1 residuals of 5/3 and 1 in the
/// derivative 3 (P1 - P0), so a third of that here; the corrected points leave none. Points times 9 are integers.
TEST(SplineResiduals, SeeThePrintedBackSubstitution) {
  const std::vector<double> k{0, 9, 0, 9};
  const std::vector<double> right{0, 5, 10, 9, 9, 8, 1, 0, 0, -1, 4, 9};
  const std::vector<double> printed{0, 5, -5, 9, 9, 8, 10, 0, 0, -1, 4, 9};
  const auto none = spline_residuals(k, right);
  for (const auto* residual : {&none.data, &none.c0, &none.c1, &none.c2, &none.natural}) expect_equal(*residual, 0, 1);
  const auto wrong = spline_residuals(k, printed);
  expect_equal(wrong.c1, 15, 1);  // (8 - 9) - (9 + 5); the other is (-1 - 0) - (0 - 10) = 9
  expect_equal(wrong.data, 0, 1);
  EXPECT_GT(wrong.c2.numerator, 0);
  EXPECT_GT(wrong.natural.numerator, 0);
  expect_equal(inner_point_error(exact_spline(k), printed), 15, 1);  // -5 instead of 10
}

/// Each condition notices what breaks it, whatever the exponents: a straight spline with one coordinate moved.
TEST(SplineResiduals, AreThoseOfEachCondition) {
  const std::vector<double> k{0, 3, 6};
  const auto moved = [&](std::size_t at) {
    std::vector<double> segments{0, 1, 2, 3, 3, 4, 5, 6};
    segments[at] += 0.25;
    const auto all = spline_residuals(k, segments);
    std::vector<double> quarters;
    for (const auto* residual : {&all.data, &all.c0, &all.c1, &all.c2, &all.natural})
      quarters.push_back(4 * round_to(binary64, *residual));
    return quarters;
  };
  EXPECT_EQ(moved(0), (std::vector<double>{1, 0, 0, 0, 1}));
  EXPECT_EQ(moved(1), (std::vector<double>{0, 0, 0, 1, 2}));
  EXPECT_EQ(moved(2), (std::vector<double>{0, 0, 1, 2, 1}));
  EXPECT_EQ(moved(3), (std::vector<double>{1, 1, 1, 1, 0}));
  EXPECT_EQ(moved(5), (std::vector<double>{0, 0, 1, 2, 1}));
  EXPECT_EQ(moved(7), (std::vector<double>{1, 0, 0, 0, 1}));
}

/// The exact points, where they are doubles, have no residual: a power of two times the determinant is cleared.
TEST(ExactSpline, HasNoResidual) {
  std::mt19937_64 words(1);
  for (const std::size_t n : {1U, 2U, 3U, 5U, 8U}) {
    std::vector<double> k;
    for (std::size_t i = 0; i <= n; ++i) k.push_back(static_cast<double>(words() % 2001) - 1000);
    const auto once = exact_spline(k);
    const double clear = once.first[0].denominator.get_d() * 2;
    for (double& x : k) x *= clear;
    const auto spline = exact_spline(k);
    std::vector<double> segments;
    for (std::size_t i = 0; i < n; ++i)
      segments.insert(segments.end(),
                      {k[i], round_to(binary64, spline.first[i]), round_to(binary64, spline.second[i]), k[i + 1]});
    expect_equal(inner_point_error(spline, segments), 0, 1);
    const auto residuals = spline_residuals(k, segments);
    for (const auto* residual : {&residuals.data, &residuals.c0, &residuals.c1, &residuals.c2, &residuals.natural})
      expect_equal(*residual, 0, 1);
  }
}

}  // namespace
}  // namespace bezierbench::reference
