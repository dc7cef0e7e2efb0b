// SPDX-License-Identifier: MIT
#include "reference/companion/exact_split.hpp"

#include <gtest/gtest.h>

#include <limits>

#include "reference/rational_test.hpp"

namespace bezierbench::reference {
namespace {

/// sum c_j C(n,j) x^j y^(n-j), term by term.
Rational bernstein(const std::vector<Rational>& c, const Rational& x, const Rational& y) {
  const auto n = c.size() - 1;
  Rational sum;
  mpz_class binomial;
  for (std::size_t j = 0; j <= n; ++j) {
    mpz_bin_uiui(binomial.get_mpz_t(), n, j);
    Rational term = c[j] * Rational{binomial, 1, 0};
    for (std::size_t k = 0; k < j; ++k) term = term * x;
    for (std::size_t k = j; k < n; ++k) term = term * y;
    sum = sum + term;
  }
  return sum;
}

/// The control points of one axis with their weights multiplied in: polynomials, of which homogeneous ones consist.
std::vector<Rational> homogeneous(const ExactHalf& half, int axis) {
  std::vector<Rational> c;
  for (std::size_t i = 0; i < half.points.size(); ++i) {
    const Rational x = half.points[i].coordinate(axis);
    c.push_back(half.weights.empty() ? x : x * half.weights[i]);
  }
  return c;
}

const Rational one{1, 1, 0};

/// Two polynomials of degree n are one where they agree at n + 1 places: at every s the left half is the whole at st,
/// and the right half the whole at t + s(1-t).
void expect_halves_of(const std::vector<Rational>& whole, const std::vector<Rational>& left,
                      const std::vector<Rational>& right, double t) {
  ASSERT_EQ(left.size(), whole.size());
  ASSERT_EQ(right.size(), whole.size());
  const Rational at = exactly(t);
  for (std::size_t k = 0; k < whole.size(); ++k) {
    const Rational s{mpz_class(static_cast<unsigned long>(k)), 1, -3};
    const Rational in_left = s * at;
    const Rational in_right = at + s * (one - at);
    EXPECT_TRUE(same(bernstein(left, s, one - s), bernstein(whole, in_left, one - in_left))) << "t " << t;
    EXPECT_TRUE(same(bernstein(right, s, one - s), bernstein(whole, in_right, one - in_right))) << "t " << t;
  }
}

const std::vector<double> split_t{0,         1,          0.5, 1.0 / 3, 0x1p-53, 1 - 0x1p-53,
                                  0x1p-1074, -0x1p-1074, 2.5, -1e300,  1e-300,  std::numeric_limits<double>::max()};
const std::vector<std::vector<double>> split_c{
    {3.25},
    {0, 0, 0},
    {-0.0, 1},
    {0x1p-1074, -0x1p-1074, 0x1p-1070},
    {1e308, -1e308, 1e308, -1e308},
    {1e308, 1e-308, -0x1p-1074, 1},
    {0.1, 0.2, 0.3, -0.4, 0.5, 0.6, -0.7, 0.8, 0.9},
};

TEST(ExactSplit, HalvesAreTheCurveOverTheirIntervals) {
  for (const auto& c : split_c)
    for (const double t : split_t) {
      const auto halves = exact_split({Form::bernstein, 1, static_cast<int>(c.size()) - 1, c}, t);
      std::vector<Rational> whole;
      for (const double value : c) whole.push_back(exactly(value));
      EXPECT_TRUE(halves.left.weights.empty());
      expect_halves_of(whole, homogeneous(halves.left, 0), homogeneous(halves.right, 0), t);
    }
}

/// Numerators and weights, each on its own: one scale for both halves, not only the same curve.
TEST(ExactSplit, OfRationalCurvesIsTheSplitInHomogeneousCoordinates) {
  const std::vector<double> all_weights{0x1p+60, 0x1p-60, 1, 3, 0x1p-60, 0x1p+60, 0.1, 1, 7};
  for (const auto& c : split_c)
    for (const double t : {0.0, 1.0, 0.5, 1.0 / 3, 0x1p-53, 1 - 0x1p-53, 0x1p-1074}) {
      const std::vector<double> w(all_weights.begin(), all_weights.begin() + static_cast<std::ptrdiff_t>(c.size()));
      const auto halves = exact_split({Form::rational, 1, static_cast<int>(c.size()) - 1, c, w}, t);
      std::vector<Rational> weights;
      std::vector<Rational> weighted;
      for (std::size_t i = 0; i < c.size(); ++i) {
        weights.push_back(exactly(w[i]));
        weighted.push_back(exactly(w[i]) * exactly(c[i]));
      }
      expect_halves_of(weights, halves.left.weights, halves.right.weights, t);
      expect_halves_of(weighted, homogeneous(halves.left, 0), homogeneous(halves.right, 0), t);
    }
}

/// The middles of the exact halves, term by term; neither t/2 nor (1 + t)/2 need be a double.
TEST(ExactSplit, MiddlesAreThoseOfTheHalves) {
  const Rational half{1, 1, -1};
  for (const auto& c : split_c)
    for (const double t : split_t) {
      const CurveView<double> curve{Form::bernstein, 1, static_cast<int>(c.size()) - 1, c};
      const auto halves = exact_split(curve, t);
      const auto middles = exact_middles(curve, t);
      EXPECT_TRUE(same(middles.left.at(0), bernstein(homogeneous(halves.left, 0), half, half))) << t;
      EXPECT_TRUE(same(middles.right.at(0), bernstein(homogeneous(halves.right, 0), half, half))) << t;
    }
  const std::vector<double> c{1, 0, 1, 1, 0, 1};  // the circle: at 1/2 in (3/5, 4/5)
  const std::vector<double> w{1, 1, 2};
  const auto middles = exact_middles({Form::rational, 2, 2, c, w}, 1);
  EXPECT_TRUE(same(middles.left.at(0), Rational{3, 5, 0}));
  EXPECT_TRUE(same(middles.left.at(1), Rational{4, 5, 0}));
  EXPECT_TRUE(same(middles.right.at(1), one));
  const std::vector<double> both{1, -1, 2, 5};
  const std::vector<double> signs{1, -1};
  EXPECT_TRUE(exact_middles({Form::rational, 2, 1, both, signs}, 1).left.empty());
}

TEST(ExactSplit, HasNoPointWhereItsWeightIsZero) {
  const std::vector<double> c{1, 2};
  const std::vector<double> w{1, -3};  // 1 - 4t
  const auto halves = exact_split({Form::rational, 1, 1, c, w}, 0.25);
  EXPECT_TRUE(halves.left.points[0].exists());
  EXPECT_FALSE(halves.left.points[1].exists());
  EXPECT_FALSE(halves.right.points[0].exists());
  EXPECT_EQ(halves.right.weights[0].numerator, 0);
}

/// In [0, 1] Bernstein values are positive, so p~ is the split of the magnitudes; outside it is more.
TEST(ExactSplit, PTildeTakesMagnitudes) {
  const std::vector<double> c{1, -2, 3, -4};
  const std::vector<double> magnitudes{1, 2, 3, 4};
  const std::vector<double> w{1, 0.5, 3, 2};
  for (const double t : {0.0, 0.3, 1.0})
    for (const Form form : {Form::bernstein, Form::rational}) {
      const std::span<const double> weights = form == Form::rational ? std::span(w) : std::span<const double>();
      const auto p_tilde = split_p_tilde({form, 1, 3, c, weights}, t);
      const auto expected = exact_split({form, 1, 3, magnitudes, weights}, t);
      ASSERT_EQ(p_tilde.left.points.size(), 4U);
      ASSERT_EQ(p_tilde.right.weights.size(), weights.size());
      for (std::size_t i = 0; i < 4; ++i) {
        EXPECT_TRUE(same(p_tilde.left.points[i].coordinate(0), expected.left.points[i].coordinate(0)));
        EXPECT_TRUE(same(p_tilde.right.points[i].coordinate(0), expected.right.points[i].coordinate(0)));
        if (form != Form::rational) continue;
        EXPECT_TRUE(same(p_tilde.left.weights[i], expected.left.weights[i]));
        EXPECT_TRUE(same(p_tilde.right.weights[i], expected.right.weights[i]));
      }
    }
  const auto outside = split_p_tilde({Form::bernstein, 1, 1, std::span(c).first(2)}, 2);  // |1||1-2| + |-2||2|
  EXPECT_TRUE(same(outside.left.points[1].coordinate(0), Rational{5, 1, 0}));
}

TEST(ExactSplit, ErrorsAreRoundedOnce) {
  const Rational third{1, 3, 0};
  EXPECT_EQ(error_of(0.25, third, binary64), 1.0 / 12);
  EXPECT_EQ(error_of(0.5, third, binary64), 1.0 / 6);
  EXPECT_EQ(error_of(0.25, third, error_format), static_cast<double>(1.0F / 12));
  EXPECT_EQ(error_of(0x1p-1074, Rational{}, binary64), 0x1p-1074);
  EXPECT_EQ(error_of(1, one, binary64), 0);
  constexpr double infinite = std::numeric_limits<double>::infinity();
  EXPECT_EQ(error_of(infinite, third, binary64), infinite);
  EXPECT_EQ(error_of(std::numeric_limits<double>::quiet_NaN(), third, binary64), infinite);
  EXPECT_EQ(error_of(-1e308, exactly(1e308), binary64), infinite);
}

}  // namespace
}  // namespace bezierbench::reference
