// SPDX-License-Identifier: MIT
#include "reference/companion/exact_roots.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <random>
#include <utility>

#include "reference/exact_curve.hpp"

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
}  // namespace bezierbench::reference
