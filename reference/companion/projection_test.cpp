// SPDX-License-Identifier: MIT
#include "reference/companion/projection.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "reference/companion/integer_polynomial.hpp"
#include "reference/exact_curve.hpp"

namespace bezierbench::reference {
namespace {

ExactProjection project(const std::vector<double>& points, const std::vector<double>& point) {
  const int d = static_cast<int>(point.size());
  return projection({Form::bernstein, d, static_cast<int>(points.size()) / d - 1, points}, point);
}

double t_of(const CriticalPoint& point) { return round_to(binary64, point.t); }
double distance_of(const CriticalPoint& point) { return square_root(binary64, point.distance_squared); }

TEST(IntegerPolynomial, IsolatesRootsThatLieCloseTogetherAndAtTheEnds) {
  // t (2t - 1)^2 (t - 1) (4096 t - 1365) (4096 t - 1366): roots 0, 1/2 (double), 1, and two 2^-12 apart
  IntegerPolynomial p{1};
  const auto times = [&p](long a, long b) {  // a t + b
    IntegerPolynomial next(p.size() + 1, 0);
    for (std::size_t i = 0; i < p.size(); ++i) {
      next[i] += p[i] * b;
      next[i + 1] += p[i] * a;
    }
    p = next;
  };
  times(1, 0);
  times(2, -1);
  times(2, -1);
  times(1, -1);
  times(4096, -1365);
  times(4096, -1366);
  auto roots = isolate_roots(square_free(p));
  ASSERT_EQ(roots.size(), 5U);
  std::vector<double> found;
  for (auto& root : roots) {
    refine(square_free(p), root, 60);
    found.push_back(std::ldexp(root.t.k.get_d(), -static_cast<int>(root.t.shift)));
  }
  EXPECT_THAT(found, testing::ElementsAre(0, 1365 * 0x1p-12, 1366 * 0x1p-12, 0.5, 1));
}

TEST(ExactProjection, FindsFiveInteriorCriticalPoints) {
  const auto exact = project({-3, 1, 4, -7, -4, 7, 3, -1}, {0, 0});
  ASSERT_EQ(exact.critical.size(), 7U);
  const std::vector<double> printed{0, 0.13301, 0.23046, 0.5, 0.76954, 0.86699, 1};
  for (std::size_t i = 0; i < printed.size(); ++i) EXPECT_NEAR(t_of(exact.critical[i]), printed[i], 5e-6);
  EXPECT_EQ(exact.nearest, 3U);
  EXPECT_EQ(distance_of(exact.foot()), 0);
}

/// Square roots that are known otherwise: onto (t, t^2 / 2) from (0, 1) every distance is sqrt(1 + t^4 / 4); from
/// (0, 2) the foot is at t^2 = 2, at the distance sqrt(3).
TEST(ExactProjection, OntoAParabola) {
  const std::vector<double> parabola{0, 0, 1, 0, 2, 2};  // (2s, 2s^2), s in [0,1]: t = 2s
  const auto at_vertex = project(parabola, {0, 1});      // the centre of curvature: a triple root at s = 0
  EXPECT_EQ(t_of(at_vertex.foot()), 0);
  EXPECT_EQ(distance_of(at_vertex.foot()), 1);
  EXPECT_EQ(at_vertex.critical.size(), 2U);
  const auto above = project(parabola, {0, 2});
  EXPECT_EQ(t_of(above.foot()), std::sqrt(0.5));
  EXPECT_EQ(distance_of(above.foot()), std::sqrt(3.0));
}

TEST(ExactProjection, KnowsThatThePointIsOnTheCurve) {
  const auto third = project({0, 0, 3, 0}, {1, 0});  // at t = 1/3, which is not a dyadic number
  EXPECT_EQ(t_of(third.foot()), 1.0 / 3);
  EXPECT_EQ(third.foot().distance_squared.numerator, 0);
  const auto beside = project({0, 0, 3, 0}, {1, 0x1p-60});
  EXPECT_EQ(distance_of(beside.foot()), 0x1p-60);
}

TEST(ExactProjection, OfTwoEquallyNearPointsItTakesTheFirst) {
  const auto exact = project({-2, 0, -1, 3, 1, 3, 2, 0}, {0, -1});
  EXPECT_EQ(exact.nearest, 0U);
  EXPECT_EQ(distance_of(exact.critical.front()), distance_of(exact.critical.back()));
}

/// Feet that are equally near at irrational parameters, for which no number of digits shows that they are.
TEST(ExactProjection, OfEquallyNearPointsAtIrrationalParametersItTakesTheFirst) {
  // B(t) = -6 t (1 - t) (1, 1): the foot is (-1/2, -1/2), 6 t (1 - t) = 1/2
  EXPECT_DOUBLE_EQ(t_of(project({0, 0, -2, -2, -2, -2, 0, 0}, {-1, 0}).foot()), (1 - std::sqrt(2.0 / 3)) / 2);
  // x = 5 (3 t^2 - 2 t), symmetric about t = 1/3: x = -1 twice
  EXPECT_DOUBLE_EQ(t_of(project({0, 0, -5, 0, 5, 0}, {-1, 5}).foot()), (1 - std::sqrt(2.0 / 5)) / 3);
  // x = 40 + 40 t (t^2 - 2 t + 1/2)^2 is 40 at t = 0 and at 1 - sqrt(1/2), and larger elsewhere
  EXPECT_EQ(project({40, 42, 36, 42, 48, 50}, {0}).nearest, 0U);
  EXPECT_DOUBLE_EQ(t_of(project({50, 48, 42, 36, 42, 40}, {0}).foot()), std::sqrt(0.5));
}

TEST(ExactProjection, TellsFeetApartWhoseDistancesDifferInTheThirtiethDigit) {
  // the second curve above with y = 2^-100 t^2: the later of both feet is nearer by less than 2^-101
  EXPECT_GT(t_of(project({0, 0, -5, 0, 5, 0x1p-100}, {-1, 5}).foot()), 0.5);
}

TEST(ExactProjection, OntoACurveThatIsAPoint) {
  const auto exact = project({1, 2, 3, 1, 2, 3}, {3, 4, 4});
  EXPECT_EQ(distance_of(exact.foot()), 3);
}

ExactProjection project(const std::vector<double>& points, const std::vector<double>& weights,
                        const std::vector<double>& point) {
  const int d = static_cast<int>(point.size());
  return projection({Form::rational, d, static_cast<int>(weights.size()) - 1, points, weights}, point);
}

/// On the circle ((1 - t^2) / (1 + t^2), 2t / (1 + t^2)) the foot of (3, 4) is at t = 1/2, where the tangent of the
/// angle is 4/3.
TEST(ExactProjection, OntoAQuarterCircle) {
  const std::vector<double> circle{1, 0, 1, 1, 0, 1};
  const std::vector<double> weights{-1, -1, -2};
  const auto far = project(circle, weights, {3, 4});
  EXPECT_EQ(t_of(far.foot()), 0.5);
  EXPECT_EQ(distance_of(far.foot()), 4);
  EXPECT_EQ(far.critical.size(), 3U);
  const auto diagonal = project(circle, weights, {2, 2});  // t = tan(pi / 8), the distance sqrt(8) - 1
  EXPECT_DOUBLE_EQ(t_of(diagonal.foot()), std::sqrt(2.0) - 1);
  EXPECT_DOUBLE_EQ(distance_of(diagonal.foot()), std::sqrt(8.0) - 1);
  EXPECT_NEAR(distance_of(project(circle, weights, {0.6, 0.8}).foot()), 2.2204e-17, 1e-20);  // the point is rounded
  const auto centre = project(circle, weights, {0, 0});
  EXPECT_EQ(t_of(centre.foot()), 0);
  EXPECT_EQ(distance_of(centre.foot()), 1);
  const auto behind = project(circle, weights, {-1, -1});  // both ends are as near
  EXPECT_EQ(behind.nearest, 0U);
  EXPECT_EQ(distance_of(behind.foot()), std::sqrt(5.0));
  EXPECT_EQ(foot_error(binary64, 0.5, 4.25, far), 0.25);
  EXPECT_NEAR(foot_error(binary64, 0, 4, far), std::sqrt(20.0) - 4, 1e-15);
}

/// 1 / (1 - 3t + 3t^2) is 2 at 1/2 -+ sqrt(1/12) and at no rational parameter: both feet are as near, the first counts.
TEST(ExactProjection, OfEquallyNearPointsOfARationalCurveItTakesTheFirst) {
  const auto both = project({1, -2, 1}, {1, -0.5, 1}, {2});
  EXPECT_NEAR(t_of(both.foot()), (1 - std::sqrt(1 / 3.0)) / 2, 1e-15);
  EXPECT_EQ(distance_of(both.foot()), 0);
}

/// All points of these curves have x = 10 and run from y = 10 through 0 to y < 0, so that the foot of (1, 0) is
/// (10, 0), however near its parameter is to 1.
TEST(ExactProjection, OntoCurvesWithWeightsFarApart) {
  EXPECT_EQ(distance_of(project({10, 10, 10, 0, 10, -10}, {1, 1e-100, 1e-100}, {1, 0}).foot()), 9);
  std::vector<double> points;
  std::vector<double> weights;
  for (int i = 0; i <= 20; ++i) {
    points.insert(points.end(), {10, 10.0 - i});
    weights.push_back(i == 0 ? 1 : 1e-155);
  }
  EXPECT_EQ(distance_of(project(points, weights, {1, 0}).foot()), 9);
}

TEST(ExactProjection, NoSampleOfARationalCurveIsNearer) {
  std::mt19937_64 words(15);
  ExactCurve exact_curve;
  for (int trial = 0; trial < 40; ++trial) {
    const int n = 1 + trial % 5;
    std::vector<double> points;
    std::vector<double> weights;
    for (int i = 0; i <= n; ++i) {
      for (int axis = 0; axis < 2; ++axis) points.push_back(static_cast<double>(words() >> 11U) * 0x1p-53);
      const bool small = trial % 2 == 1 && i > 0 && i < n;  // of both signs, without a pole
      weights.push_back(small ? -std::ldexp(1.0, -4 - i) : 1 + static_cast<double>(words() >> 11U) * 0x1p-53);
    }
    const std::vector<double> point{0.5, static_cast<double>(trial % 7)};
    const auto exact = project(points, weights, point);
    const double least = distance_of(exact.foot());
    for (int k = 0; k <= 256; ++k) {
      const auto& there = exact_curve.point({Form::rational, 2, n, points, weights}, k / 256.0);
      Rational square;
      for (int axis = 0; axis < 2; ++axis) {
        const Rational offset = there.coordinate(axis) - exactly(point[static_cast<std::size_t>(axis)]);
        square = square + offset * offset;
      }
      EXPECT_GE(square_root(binary64, square), least * (1 - 0x1p-52)) << "trial " << trial << " k " << k;
      EXPECT_EQ(square_root(binary64, square), square_root(binary64, exact.distance_squared_at(k / 256.0)));
    }
  }
}

/// No point of a fine grid is nearer, and the foot point is as far as the exact curve says it is.
TEST(ExactProjection, NoSampleIsNearer) {
  std::mt19937_64 words(5);
  const auto number = [&words] { return static_cast<double>(static_cast<std::int64_t>(words())) * 0x1p-63; };
  ExactCurve exact_curve;
  for (int trial = 0; trial < 40; ++trial) {
    const int d = 1 + trial % 3;
    const int n = 1 + trial % 9;
    std::vector<double> points(static_cast<std::size_t>(d * (n + 1)));
    std::vector<double> point(static_cast<std::size_t>(d));
    for (double& x : points) x = number();
    for (double& x : point) x = number();
    const CurveView<double> curve{Form::bernstein, d, n, points};
    const auto exact = projection(curve, point);
    const double least = distance_of(exact.foot());
    for (int i = 0; i <= 256; ++i)
      EXPECT_GE(distance(exact_curve.point(curve, i / 256.0), exactly(point)), least * (1 - 0x1p-23)) << trial;
    const double there = distance(exact_curve.point(curve, t_of(exact.foot())), exactly(point));
    EXPECT_NEAR(there, least, 0x1p-23 * least + 0x1p-50) << trial;
  }
}

TEST(DistanceError, IsRoundedOnce) {
  EXPECT_EQ(distance_error(binary64, 2, {4, 1, 0}), 0);
  EXPECT_EQ(distance_error(binary64, 1, {1, 1, -200}), 1);  // 1 - 2^-100 rounds to 1
  EXPECT_NEAR(distance_error(binary64, std::sqrt(2.0), {2, 1, 0}), 9.667293313452913e-17, 1e-31);
}

/// On the line (4 t, 0) from (1, 2), (C - P).C' = 16 (t - 1/4), with D = M = 4 and |C - P| = 2 at the foot.
TEST(Projection, ResidualsAreCountedInRoundings) {
  const auto exact = project({0, 0, 4, 0}, {1, 2});
  EXPECT_EQ(foot_residual(0.25, exact), 0);
  EXPECT_NEAR(foot_residual(0.25 + 0x1p-52, exact), 32 / (4 * (2 + 4 * 0.25)), 1e-6);
  EXPECT_NEAR(foot_residual(0, exact), 4 / (4 * 0x1p-53 * std::sqrt(5)), 1e10);
  EXPECT_EQ(foot_residual(1, project({0, 0, 4, 0}, {7, 2})), 0);  // the distance falls to the end
  EXPECT_EQ(foot_residual(-0x1p-60, exact), std::numeric_limits<double>::infinity());
}

/// A foot point is off by where it lies, too: 3e-30 next to 1e300 is not a distance to a method that scales both.
TEST(Projection, AFootPointIsJudgedByItsPlace) {
  const std::vector<double> points{1e300, 0, 1e300, 1e-30, 1e300, 3e-30};
  const std::vector<double> end{1e300, 3e-30};
  const auto exact = projection({Form::bernstein, 2, 2, points}, end);
  EXPECT_EQ(foot_error(binary64, 1, 0, exact), 0);
  EXPECT_EQ(foot_error(binary64, 0, 0, exact), 3e-30);
  EXPECT_EQ(foot_error(binary64, 1, 5, exact), 5);
  EXPECT_NEAR(foot_error(binary64, 0.5, 0, exact), 1.75e-30, 1e-45);  // y = 2t + t^2 in 1e-30
  EXPECT_EQ(foot_error(binary64, std::nan(""), 0, exact), std::numeric_limits<double>::infinity());
  EXPECT_EQ(foot_error(binary64, 1, std::nan(""), exact), std::numeric_limits<double>::infinity());
}

}  // namespace
}  // namespace bezierbench::reference
