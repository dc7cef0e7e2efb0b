// SPDX-License-Identifier: MIT
#include "reference/companion/exact_roots.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <map>
#include <random>
#include <utility>
#include <vector>

#include "reference/exact_curve.hpp"
#include "reference/rational.hpp"

namespace bezierbench::reference {

namespace {

using Numbers = std::vector<double>;

/// Roots with their multiplicities.
std::vector<std::pair<double, int>> listed(const Roots& found) {
  std::vector<std::pair<double, int>> result;
  for (const auto& [t, multiplicity] : found.roots) result.emplace_back(t, multiplicity);
  return result;
}
using Expected = std::vector<std::pair<double, int>>;

CurveView<double> plane(const Numbers& points, const Numbers& weights = {}) {
  return {weights.empty() ? Form::bernstein : Form::rational, 2, static_cast<int>(points.size()) / 2 - 1, points,
          weights};
}

/// The sign of the coordinate minus `value`, from the exact point.
int sign(const CurveView<double>& curve, double t, double value) {
  const auto off = ExactCurve().point(curve, t).coordinate(0) - exactly(value);
  return sgn(off.numerator);
}

/// Products of factors 8t - k are exact in power form, and their roots are doubles.
TEST(ExactRoots, FindsTheRootsOfProductsWithTheirMultiplicities) {
  std::mt19937 random(1);
  for (int trial = 0; trial < 200; ++trial) {
    std::map<double, int> roots;
    Numbers p{1};
    for (int factor = 0; factor < 7; ++factor) {
      const int k = static_cast<int>(random() % 9);
      ++roots[k / 8.0];
      p.push_back(0);
      for (std::size_t i = p.size() - 1; i > 0; --i) p[i] = 8 * p[i - 1] - k * p[i];
      p[0] *= -k;
    }
    const CurveView<double> curve{Form::power, 1, 7, p, {}};
    EXPECT_EQ(listed(roots_of_value(curve, 0, 0)), Expected(roots.begin(), roots.end()));
  }
}

/// 2^10 t^3 - 2^-1074 t^2: the simple root, 2^-1084, rounds to 0, too, but stands behind the double one.
TEST(ExactRoots, RootsThatRoundToOneDoubleAreInTheirOrder) {
  const Numbers p{0, 0, -0x1p-1074, 0x1p10};
  EXPECT_EQ(listed(roots_of_value({Form::power, 1, 3, p, {}}, 0, 0)), (Expected{{0, 2}, {0, 1}}));
}

/// A simple root lies between the neighbours of the double found, at which the signs differ. By Descartes' rule the
/// number of roots is that of the sign variations of the coefficients, or an even number less.
TEST(ExactRoots, EveryRootOfARandomCurveIsBracketedByNeighbours) {
  std::mt19937_64 random(2);
  std::uniform_real_distribution<double> coordinate(-1, 1);
  std::uniform_real_distribution<double> positive(0.1, 4);
  int found = 0;
  for (int trial = 0; trial < 300; ++trial) {
    const int n = 1 + trial % 9;
    Numbers b;
    Numbers w;
    for (int i = 0; i <= n; ++i) {
      b.push_back(coordinate(random));
      if (trial % 2 == 0) w.push_back(positive(random));
    }
    const CurveView<double> curve{w.empty() ? Form::bernstein : Form::rational, 1, n, b, w};
    const double value = coordinate(random) / 4;
    const auto roots = roots_of_value(curve, 0, value).roots;
    int variations = 0;
    for (int i = 1; i <= n; ++i) variations += (curve(0, i) > value) != (curve(0, i - 1) > value) ? 1 : 0;
    EXPECT_LE(static_cast<int>(roots.size()), variations);
    EXPECT_EQ(static_cast<int>(roots.size()) % 2, variations % 2);
    for (const auto& [t, multiplicity] : roots) {
      EXPECT_EQ(multiplicity, 1);
      EXPECT_EQ(sign(curve, std::nextafter(t, -1), value) * sign(curve, std::nextafter(t, 2), value), -1);
      ++found;
    }
  }
  EXPECT_GT(found, 100);
}

/// p = 3t (1-t) (1-2t) has extrema at (3 -+ sqrt(3)) / 6, of which 1/2 - sqrt(3)/6 = 0.21132486540518711775.
TEST(ExactRoots, Extrema) {
  const Numbers b{0, 1, -1, 0};
  EXPECT_EQ(listed(roots_of_derivative({Form::bernstein, 1, 3, b, {}}, 0)),
            (Expected{{0.21132486540518711775, 1}, {0.78867513459481288225, 1}}));
}

/// Quarter of the unit circle, ((1-t^2), 2t) / (1+t^2): dx/dt is 0 at 0 and dy/dt at 1, and no point has curvature 0.
TEST(ExactRoots, RationalCurves) {
  const Numbers points{1, 0, 1, 1, 0, 1};
  const Numbers weights{1, 1, 2};
  const auto circle = plane(points, weights);
  EXPECT_EQ(listed(roots_of_derivative(circle, 0)), (Expected{{0, 1}}));
  EXPECT_EQ(listed(roots_of_derivative(circle, 1)), (Expected{{1, 1}}));
  EXPECT_EQ(listed(roots_of_value(circle, 1, 0)), (Expected{{0, 1}}));
  EXPECT_EQ(listed(roots_of_value(circle, 0, 0)), (Expected{{1, 1}}));
  EXPECT_TRUE(roots_of_curvature(circle).roots.empty());
  EXPECT_FALSE(roots_of_curvature(circle).everywhere);
}

/// An S, a cusp at 1/2 and a straight line. A line with weights is straight, too.
TEST(ExactRoots, Inflections) {
  const Numbers s{0, 0, 1, 1, 2, -1, 3, 0};
  const Numbers cusp{0, 0, 1, 1, 0, 1, 1, 0};
  const Numbers line{0, 0, 1, 2, 2, 4, 4, 8};
  EXPECT_EQ(listed(roots_of_curvature(plane(s))), (Expected{{0.5, 1}}));
  EXPECT_EQ(listed(roots_of_curvature(plane(cusp))), (Expected{{0.5, 2}}));
  EXPECT_TRUE(roots_of_curvature(plane(line)).everywhere);
  EXPECT_TRUE(roots_of_curvature(plane(line, {1, 3, 2, 1})).everywhere);
}

/// Weights move the inflection of an S, but not its existence: x'y'' - x''y' changes its sign between neighbours of t.
TEST(ExactRoots, InflectionsOfRationalCurves) {
  const Numbers s{0, 0, 1, 1, 2, -1, 3, 0};
  const Numbers weights{1, 2, 1, 1};
  const auto curve = plane(s, weights);
  const auto found = listed(roots_of_curvature(curve));
  ASSERT_EQ(found.size(), 1U);
  const auto curvature_sign = [&](double t) {
    ExactCurve exact;
    const ExactPoint first = exact.derivative(curve, 1, t);
    const ExactPoint second = exact.derivative(curve, 2, t);
    return sgn((first.coordinate(0) * second.coordinate(1) - second.coordinate(0) * first.coordinate(1)).numerator);
  };
  EXPECT_EQ(curvature_sign(std::nextafter(found[0].first, 0)) * curvature_sign(std::nextafter(found[0].first, 1)), -1);
}

TEST(ExactRoots, EveryParameterOfAConstant) {
  const Numbers b{2, 2, 2};
  const CurveView<double> curve{Form::bernstein, 1, 2, b, {}};
  EXPECT_TRUE(roots_of_value(curve, 0, 2).everywhere);
  EXPECT_FALSE(roots_of_value(curve, 0, 1).everywhere);
  EXPECT_TRUE(roots_of_derivative(curve, 0).everywhere);
}

}  // namespace

namespace {

std::optional<double> pole_of(const std::vector<double>& weights, double from = 0, double to = 1) {
  const std::vector<double> points(weights.size(), 1.0);
  return pole({Form::rational, 1, static_cast<int>(weights.size()) - 1, points, weights}, from, to);
}

TEST(Pole, IsTheFirstRootOfTheDenominator) {
  EXPECT_EQ(pole_of({1, -3}), 0.25);
  EXPECT_EQ(pole_of({1, -1, 1}), 0.5);                                 // a double root
  EXPECT_NEAR(*pole_of({1, -2, 1}), (3 - std::sqrt(3.0)) / 6, 1e-15);  // 1 - 6t + 6t^2
  EXPECT_NEAR(*pole_of({1, -2, 1}, 0.5), (3 + std::sqrt(3.0)) / 6, 1e-15);
  EXPECT_EQ(pole_of({0, 1}), 0);
  EXPECT_EQ(pole_of({1, 0}), 1);
  EXPECT_EQ(pole_of({0, 0}), 0);
}

TEST(Pole, IsNoneWhereTheDenominatorKeepsItsSign) {
  EXPECT_EQ(pole_of({1, 2, 1}), std::nullopt);
  EXPECT_EQ(pole_of({-1, -2, -1}), std::nullopt);
  EXPECT_EQ(pole_of({1, -0.5, 1}), std::nullopt);
  EXPECT_EQ(pole_of({1, std::nextafter(-1.0, 0.0), 1}), std::nullopt);
  EXPECT_TRUE(pole_of({1, std::nextafter(-1.0, -2.0), 1}).has_value());
}

TEST(Pole, IsSoughtInThePartOnly) {
  EXPECT_EQ(pole_of({1, -3}, 0.25, 0.5), 0.25);
  EXPECT_EQ(pole_of({1, -3}, 0, 0.25), 0.25);
  EXPECT_EQ(pole_of({1, -3}, std::nextafter(0.25, 1), 0.5), std::nullopt);
  EXPECT_EQ(pole_of({1, -3}, 0, std::nextafter(0.25, 0)), std::nullopt);
  EXPECT_EQ(pole_of({1, -2}, 0, std::nextafter(1 / 3.0, 0)), std::nullopt);
  EXPECT_TRUE(pole_of({1, -2}, std::nextafter(1 / 3.0, 0), std::nextafter(1 / 3.0, 1)).has_value());
}

}  // namespace

namespace {

ExactRange range_of(const std::vector<double>& b, const std::vector<double>& w = {}) {
  return exact_range({w.empty() ? Form::bernstein : Form::rational, 1, static_cast<int>(b.size()) - 1, b, w}, 0);
}

/// Whether `low` is the largest double that is not above sign sqrt(square), and `high` the smallest not below.
void expect_root_between(double low, double high, const Rational& square, bool negative) {
  EXPECT_EQ(std::nextafter(low, high), high);
  const double inner = std::abs(negative ? high : low);
  const double outer = std::abs(negative ? low : high);
  EXPECT_TRUE(less(exactly(inner) * exactly(inner), square));
  EXPECT_TRUE(less(square, exactly(outer) * exactly(outer)));
}

TEST(ExactRange, EndsOfMonotoneCurves) {
  EXPECT_EQ(range_of({3}).low, 3);
  EXPECT_EQ(range_of({1, 4}).high, 4);
  EXPECT_EQ(range_of({5, 3, 1, -1}).low, -1);
  EXPECT_EQ(range_of({2, 2, 2}).high, 2);
}

/// (3t - 1)^2: the minimum is 0 at t = 1/3, which is not a double.
TEST(ExactRange, FindsThatAMinimumIsADouble) {
  const auto range = range_of({1, -2, 4});
  EXPECT_EQ(range.low, 0);
  EXPECT_EQ(range.high, 4);
  const auto moved = range_of({8, 5, 11});  // 7 more
  EXPECT_EQ(moved.low, 7);
}

/// b = 0, 1, -1, 0: p = 3t (1-t) (1-2t), with extrema -+ sqrt(3) / 6 at (3 -+ sqrt(3)) / 6.
TEST(ExactRange, EnclosesAnIrrationalExtremum) {
  const auto range = range_of({0, 1, -1, 0});
  const Rational twelfth{1, 12, 0};
  expect_root_between(std::nextafter(range.high, 0), range.high, twelfth, false);
  expect_root_between(range.low, std::nextafter(range.low, 0), twelfth, true);
}

/// b = 0, 1, 0: the maximum 1/2 at t = 1/2 is found without a root in between.
TEST(ExactRange, ExactAtDyadicParameters) {
  EXPECT_EQ(range_of({0, 1, 0}).high, 0.5);
  EXPECT_EQ(range_of({0, 1, 0}).low, 0);
}

/// The unit circle's quarter, y = 2t / (1 + t^2), and its arc from -60 to 60 degrees, with x = 1 in the middle.
TEST(ExactRange, RationalCurves) {
  EXPECT_EQ(range_of({0, 1, 1}, {1, 1, 2}).high, 1);
  const auto arc = range_of({0.5, 2, 0.5}, {1, 0.5, 1});
  EXPECT_EQ(arc.high, 1);
  EXPECT_EQ(arc.low, 0.5);
}

TEST(ExactRange, WeightsThatAreAllEqualChangeNothing) {
  const std::vector<double> b{0.1, 3.7, -2.9, 1.3};
  const auto range = range_of(b);
  const auto weighted = range_of(b, {0.3, 0.3, 0.3, 0.3});
  EXPECT_EQ(range.low, weighted.low);
  EXPECT_EQ(range.high, weighted.high);
}

/// Powers of two scale everything, also to the ends of the range.
TEST(ExactRange, ScalesWithPowersOfTwo) {
  const std::vector<double> b{0.1, 3.7, -2.9, 1.3};
  const auto range = range_of(b);
  for (const int exponent : {-900, 1000}) {
    std::vector<double> scaled;
    for (const double x : b) scaled.push_back(std::ldexp(x, exponent));
    EXPECT_EQ(range_of(scaled).low, std::ldexp(range.low, exponent));
    EXPECT_EQ(range_of(scaled).high, std::ldexp(range.high, exponent));
  }
  constexpr double tiny = std::numeric_limits<double>::denorm_min();
  EXPECT_EQ(range_of({0, tiny, 0}).high, tiny);  // half of it, rounded up
  EXPECT_EQ(range_of({0, tiny, 0}).low, 0);
}

}  // namespace

}  // namespace bezierbench::reference
