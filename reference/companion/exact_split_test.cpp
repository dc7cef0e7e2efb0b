// SPDX-License-Identifier: MIT
#include "reference/companion/exact_split.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <random>

#include "reference/exact_curve.hpp"
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

namespace {

using Numbers = std::vector<double>;

/// A curve in the plane with coordinates, and weights of a rational one, that are integers of a few bits.
struct RandomCurve {
  RandomCurve(std::mt19937& random, int degree, bool rational) : n(degree) {
    for (int i = 0; i <= n; ++i) {
      for (int axis = 0; axis < 2; ++axis) points.push_back(static_cast<double>(random() % 64) - 32);
      if (rational) weights.push_back(static_cast<double>(1 + random() % 7));
    }
  }
  [[nodiscard]] CurveView<double> view() const {
    return {weights.empty() ? Form::bernstein : Form::rational, 2, n, points, weights};
  }

  int n;
  Numbers points;
  Numbers weights;
};

TEST(ExactControlPoints, TheWholeCurveAndItsReverse) {
  std::mt19937 random(1);
  for (int trial = 0; trial < 40; ++trial) {
    const RandomCurve curve(random, trial % 7, trial % 2 == 0);
    const auto whole = control_points_of_part(curve.view(), 0, 1);
    EXPECT_EQ(whole->points, curve.points);
    EXPECT_EQ(whole->weights, curve.weights);
    const auto reversed = control_points_of_part(curve.view(), 1, 0);
    const auto d = static_cast<std::size_t>(curve.n) * 2;
    for (std::size_t i = 0; i <= d; i += 2) {
      EXPECT_EQ(reversed->points[i], curve.points[d - i]);
      EXPECT_EQ(reversed->points[i + 1], curve.points[d - i + 1]);
    }
    EXPECT_EQ(reversed->weights, Numbers(curve.weights.rbegin(), curve.weights.rend()));
  }
}

/// Against sums of Bernstein polynomials, which share no triangle with it.
TEST(ExactControlPoints, HalvesAreThoseOfASplit) {
  std::mt19937 random(2);
  for (int trial = 0; trial < 40; ++trial) {
    const RandomCurve curve(random, 1 + trial % 7, trial % 2 == 0);
    const double t = static_cast<double>(1 + random() % 1000) / 1024;
    const auto halves = exact_split(curve.view(), t);
    const auto expect_half = [&](const ExactHalf& half, double from, double to) {
      const auto part = control_points_of_part(curve.view(), from, to);
      for (std::size_t i = 0; i < half.points.size(); ++i)
        for (int axis = 0; axis < 2; ++axis)
          EXPECT_EQ(part->points[2 * i + static_cast<std::size_t>(axis)],
                    round_to(binary64, half.points[i].coordinate(axis)));
      for (std::size_t i = 0; i < half.weights.size(); ++i)
        EXPECT_EQ(part->weights[i], round_to(binary64, half.weights[i]));
    };
    expect_half(halves.left, 0, t);
    expect_half(halves.right, t, 1);
  }
}

/// At parameters of 4 bits no part of a polynomial curve is rounded: at u it is the curve at from + (to - from) u.
TEST(ExactControlPoints, PartsAreTheCurve) {
  std::mt19937 random(3);
  for (int trial = 0; trial < 60; ++trial) {
    const RandomCurve curve(random, trial % 6, false);
    const double from = static_cast<double>(random() % 64) / 16 - 2;
    const double to = static_cast<double>(random() % 64) / 16 - 2;
    const auto part = control_points_of_part(curve.view(), from, to);
    for (const double u : {0.0, 0.25, 0.5, 0.875, 1.0, -3.0}) {
      const ExactPoint a = ExactCurve().point({Form::bernstein, 2, curve.n, part->points, {}}, u);
      const ExactPoint b = ExactCurve().point(curve.view(), from + (to - from) * u);
      EXPECT_EQ(distance(a, b), 0);
    }
  }
}

/// 252 is a multiple of every C(9, i), so that dividing by them rounds no coordinate of a polynomial curve.
TEST(ExactControlPoints, ElevatedCurvesAreTheCurve) {
  std::mt19937 random(4);
  for (int trial = 0; trial < 60; ++trial) {
    RandomCurve curve(random, trial % 10, trial % 2 == 0);
    if (curve.weights.empty())
      for (double& x : curve.points) x *= 252;
    for (double& w : curve.weights) w *= 252;
    const auto elevated = elevated_control_points(curve.view(), 9);
    const CurveView<double> result{curve.view().form, 2, 9, elevated->points, elevated->weights};
    for (const double t : {0.0, 0.25, 0.5, 0.875, 1.0}) {
      const ExactPoint a = ExactCurve().point(curve.view(), t);
      const ExactPoint b = ExactCurve().point(result, t);
      if (curve.weights.empty()) {
        EXPECT_EQ(distance(a, b), 0);
      } else {
        EXPECT_LT(distance(a, b), 1e-13);  // weights are exact, control points rounded
      }
    }
  }
}

TEST(ExactControlPoints, AWeightOfZeroIsRefused) {
  const Numbers points{1, 2, 4};
  const Numbers weights{1, 1, -1};  // w(t) = 1 - 2t^2, whose blossom at 0, t is 1 and at t, 1 is 1 - 2t
  const CurveView<double> curve{Form::rational, 1, 2, points, weights};
  EXPECT_FALSE(control_points_of_part(curve, 0.5, 1).has_value());
  EXPECT_TRUE(control_points_of_part(curve, 0.25, 0.5).has_value());
}

}  // namespace

}  // namespace bezierbench::reference
