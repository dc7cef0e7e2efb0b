// SPDX-License-Identifier: MIT
// Whole B-spline curves against published control points, and against the exact points of the curves they came from.

#include "reference/companion/bspline_control_points.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

#include "reference/exact_point.hpp"
#include "reference/rational_test.hpp"

namespace bezierbench::reference {

namespace {

using Numbers = std::vector<double>;

ExactPoint point_in(const BsplineSpanView& span, double t) {
  const auto basis = ExactBsplineWeights::at(span.knots, t);
  return (span.weights.empty() ? basis : basis.with(span.weights)).sum(span.dimension, span.control_points);
}

/// At t in the span that begins with knot number `first` of `curve`, which the other curve has no knot inside.
void expect_same_points(const BsplineCurve& curve, const BsplineCurve& other, double from, double to,
                        double tolerance) {
  for (const double t : {from, 0.75 * from + 0.25 * to, to}) {
    const double middle = from + (to - from) / 2;
    const auto a = point_in(curve.span(curve.span_at(middle)), t);
    const auto b = point_in(other.span(other.span_at(middle)), t);
    EXPECT_LE(distance(a, b), tolerance) << "t " << t;
  }
}

/// On every span of `result`.
void expect_part_of(const BsplineCurve& result, const BsplineCurve& curve, double tolerance) {
  ASSERT_EQ(result.control_points.size(), result.points() * static_cast<std::size_t>(result.dimension));
  for (std::size_t k = static_cast<std::size_t>(result.degree); k < result.points(); ++k)
    if (result.knots[k] < result.knots[k + 1])
      expect_same_points(result, curve, result.knots[k], result.knots[k + 1], tolerance);
}

/// Coordinates are integers up to 64; knots are integers that repeat, up to degree + 1 times, at the ends as well.
BsplineCurve random_curve(std::mt19937& random, int degree, bool rational) {
  BsplineCurve curve{2, degree, {}, {}, {}};
  const auto n = static_cast<std::size_t>(degree);
  const std::size_t count = 2 * n + 2 + random() % 6;
  while (curve.knots.size() < count) {
    const double knot = curve.knots.empty() ? 0 : curve.knots.back() + static_cast<double>(1 + random() % 3);
    for (std::size_t times = 1 + random() % (n + 1); times > 0 && curve.knots.size() < count; --times)
      curve.knots.push_back(knot);
  }
  if (curve.begin() == curve.end()) return random_curve(random, degree, rational);
  for (std::size_t i = 0; i < curve.points(); ++i) {
    for (int axis = 0; axis < 2; ++axis) curve.control_points.push_back(static_cast<double>(random() % 128) - 64);
    if (rational) curve.weights.push_back(static_cast<double>(1 + random() % 7));
  }
  return curve;
}

/// A coordinate of at most 64 is rounded by 2^-48 at most, as a weight is by 2^-53 of itself, and both move a point by
/// no more than a few times as much.
constexpr double rounding = 0x1p-48;

double inside(const BsplineCurve& curve, std::mt19937& random) {
  return curve.begin() + (curve.end() - curve.begin()) * static_cast<double>(1 + random() % 15) / 16;
}

TEST(BsplineControlPoints, RandomCurvesStayWhereTheyAre) {
  std::mt19937 random(1);
  for (int trial = 0; trial < 200; ++trial) {
    const auto curve = random_curve(random, 1 + trial % 5, trial % 3 == 0);
    const double a = inside(curve, random);
    const double b = inside(curve, random);
    const double tolerance = curve.weights.empty() ? 2 * rounding : 8 * rounding;
    SCOPED_TRACE(testing::Message() << "trial " << trial << " from " << a << " to " << b);
    const auto inserted = with_knots_inserted(curve, Numbers{b, a, b, curve.begin()});
    expect_part_of(*inserted, curve, tolerance);
    EXPECT_TRUE(std::ranges::is_sorted(inserted->knots));
    expect_part_of(*part_of_bspline(curve, curve.begin(), b), curve, tolerance);
    if (a != b) expect_part_of(*part_of_bspline(curve, std::min(a, b), std::max(a, b)), curve, tolerance);
    const auto elevated = elevated_bspline(curve, curve.degree + 2);
    EXPECT_EQ(elevated->degree, curve.degree + 2);
    expect_part_of(*elevated, curve, tolerance);
    for (const auto* one : {&*inserted, &*elevated}) {
      EXPECT_EQ(one->begin(), curve.begin());
      EXPECT_EQ(one->end(), curve.end());
    }
  }
}

/// [Piegl and Tiller 1997], examples 5.1 and 5.2: a cubic, u = 5/2, and u = 2, which is a knot.
TEST(BsplineControlPoints, ExamplesOfTheNurbsBook) {
  const BsplineCurve cubic{1, 3, {0, 0, 0, 0, 1, 2, 3, 4, 5, 5, 5, 5}, {6, 0, 12, 18, -6, 24, 30, 3}, {}};
  const auto& p = cubic.control_points;
  const auto between = with_knots_inserted(cubic, Numbers{2.5});
  EXPECT_EQ(between->knots, (Numbers{0, 0, 0, 0, 1, 2, 2.5, 3, 4, 5, 5, 5, 5}));
  EXPECT_EQ(between->control_points, (Numbers{p[0], p[1], p[2], 17, 6, -1, p[5], p[6], p[7]}));  // 5/6, 1/2, 1/6
  const auto at_knot = with_knots_inserted(cubic, Numbers{2});
  EXPECT_EQ(at_knot->control_points, (Numbers{p[0], p[1], p[2], 16, 10, p[4], p[5], p[6], p[7]}));  // 2/3, 1/3
}

/// Known answers of the tests of tinyspline (test/c/insert_knot.c and derive.c), which give five decimals.
TEST(BsplineControlPoints, AnswersOfTinyspline) {
  const auto expect_near = [](const BsplineCurve& curve, const Numbers& points) {
    ASSERT_EQ(curve.control_points.size(), points.size());
    for (std::size_t i = 0; i < points.size(); ++i) EXPECT_NEAR(curve.control_points[i], points[i], 1e-5) << i;
  };
  const BsplineCurve cubic{2,
                           3,
                           {0, 0, 0, 0, 0.25, 0.5, 0.75, 1, 1, 1, 1},
                           {-1.75, -1, -1.5, -0.5, -1.5, 0, -1.25, 0.5, -0.75, 0.75, 0, 0.5, 0.5, 0},
                           {}};
  expect_near(*with_knots_inserted(cubic, Numbers{0.3}),
              {-1.75, -1, -1.5, -0.5, -1.5, -0.2, -1.4, 0.2, -1.21666, 0.51666, -0.75, 0.75, 0, 0.5, 0.5, 0});
  const auto twice = with_knots_inserted(cubic, Numbers{0.6, 0.6});
  EXPECT_EQ(twice->knots, (Numbers{0, 0, 0, 0, 0.25, 0.5, 0.6, 0.6, 0.75, 1, 1, 1, 1}));
  expect_near(*twice, {-1.75, -1, -1.5, -0.5, -1.5, 0, -1.3, 0.4, -1.10166, 0.55166, -0.93333, 0.63333, -0.6, 0.7, 0,
                       0.5, 0.5, 0});
  const BsplineCurve quadratic{
      2,
      2,
      {2, 2, 2, 3, 4, 5, 6, 7, 8, 9, 10, 10, 10},
      {-1.75, -1, -1.5, -0.5, -1.5, 0, -1.25, 0.5, -0.75, 0.75, 0, 0.5, 0.5, 0, 1.5, 0.5, 2, 1.5, 2.5, 1},
      {}};
  const auto slope = derivative_of_bspline(quadratic, 1);
  const auto at = point_in(slope.span(slope.span_at(8.4)), 8.4);
  EXPECT_NEAR(round_to(binary64, at.coordinate(0)), 0.8, 1e-14);
  EXPECT_NEAR(round_to(binary64, at.coordinate(1)), 0.7, 1e-14);
}

/// Points of the tests of NURBS-Python (tests/test_BSpline_Curve2D.py), which cut them off after three decimals and
/// allow 0.001: control points of the curve where a knot stands as often as the degree says.
TEST(BsplineControlPoints, AnswersOfNurbsPython) {
  const BsplineCurve curve{
      2, 3, {0, 0, 0, 0, 0.33, 0.66, 1, 1, 1, 1}, {5, 5, 10, 10, 20, 15, 35, 15, 45, 10, 50, 5}, {}};
  const auto inserted = with_knots_inserted(curve, Numbers{0.3, 0.6, 0.3, 0.6, 0.3, 0.6});
  EXPECT_NEAR(inserted->control_points[6], 18.617, 1e-3);
  EXPECT_NEAR(inserted->control_points[7], 13.377, 1e-3);
  EXPECT_NEAR(inserted->control_points[14], 32.143, 1e-3);
  EXPECT_NEAR(inserted->control_points[15], 14.328, 1e-3);
}

/// Inserted to multiplicity degree, the control point at a knot is the point of the curve; knots at an end clamp it.
/// The uniform quadratic goes through the middles of its control polygon.
TEST(BsplineControlPoints, ClampsAnEnd) {
  const BsplineCurve uniform{1, 2, {0, 1, 2, 3, 4, 5, 6}, {0, 4, 12, 2}, {}};
  const auto clamped = with_knots_inserted(uniform, Numbers{2, 2, 3, 4, 4});
  EXPECT_EQ(clamped->knots, (Numbers{2, 2, 2, 3, 3, 4, 4, 4}));
  EXPECT_EQ(clamped->control_points, (Numbers{2, 4, 8, 12, 7}));
  EXPECT_EQ(part_of_bspline(uniform, 2, 3)->control_points, (Numbers{2, 4, 8}));
}

TEST(BsplineControlPoints, LeavesOutPointsWithoutInfluence) {
  const BsplineCurve curve{1, 1, {0, 1, 1, 1, 1, 2, 2, 2}, {9, 8, 1, 9, 5, 9}, {}};
  const auto same = with_knots_inserted(curve, Numbers{});
  EXPECT_EQ(same->knots, (Numbers{1, 1, 2, 2}));
  EXPECT_EQ(same->control_points, (Numbers{9, 5}));
}

TEST(BsplineControlPoints, RemovesWhatWasInserted) {
  std::mt19937 random(2);
  for (int trial = 0; trial < 100; ++trial) {
    const auto curve = random_curve(random, 1 + trial % 4, false);
    const auto trimmed = *with_knots_inserted(curve, Numbers{});
    const double u = inside(trimmed, random);
    const auto most = trimmed.degree - std::ranges::count(trimmed.knots, u);
    if (most < 1) continue;
    const Numbers knots(1 + random() % static_cast<unsigned>(most), u);
    auto more = *with_knots_inserted(trimmed, knots);
    const auto back = with_knots_removed(more, knots);
    EXPECT_EQ(back->curve.knots, trimmed.knots);
    EXPECT_LT(back->deviation, 1e-9);
    if (back->deviation > 0) expect_part_of(more, back->curve, back->deviation * (1 + 0x1p-23));
    for (std::size_t i = 0; i < trimmed.control_points.size(); ++i)
      EXPECT_NEAR(back->curve.control_points[i], trimmed.control_points[i], 1e-9);
  }
}

/// Without any rounding: thirds and halves of multiples of 6.
TEST(BsplineControlPoints, DecidesExactlyWhatCanBeRemoved) {
  const BsplineCurve cubic{1, 3, {0, 0, 0, 0, 1, 2, 2.5, 3, 4, 5, 5, 5, 5}, {6, 0, 12, 17, 6, -1, 24, 30, 3}, {}};
  const auto removed = with_knots_removed(cubic, Numbers{2.5});
  EXPECT_EQ(removed->deviation, 0);
  EXPECT_EQ(removed->curve.control_points, (Numbers{6, 0, 12, 18, -6, 24, 30, 3}));
  EXPECT_GT(with_knots_removed(cubic, Numbers{2})->deviation, 0);
  const BsplineCurve corner{2, 1, {0, 0, 1, 2, 2}, {0, 0, 3, 4, 0, 0}, {}};  // from a point to (3, 4) and back
  EXPECT_EQ(with_knots_removed(corner, Numbers{1})->deviation, 5);
  const BsplineCurve heavy{2, 1, {0, 0, 1, 2, 2}, {0, 0, 3, 4, 0, 0}, {1, 1000, 1}};  // goes as far, on another way
  EXPECT_EQ(with_knots_removed(heavy, Numbers{1})->deviation, 5);
  const BsplineCurve bump{1, 3, {0, 0, 0, 0, 1, 2, 2, 2, 2}, {0, 1, 5, 1, 0}, {}};
  const auto flatter = with_knots_removed(bump, Numbers{1});
  EXPECT_EQ(flatter->curve.control_points, (Numbers{0, 2, 2, 0}));  // 2 d_1 - d_0 and 2 d_3 - d_4
  EXPECT_EQ(flatter->deviation, 3);                                 // the middle one becomes (2 + 2) / 2
  const BsplineCurve jump{1, 1, {0, 0, 1, 1, 2, 2}, {0, 3, 3, 7}, {}};
  EXPECT_EQ(with_knots_removed(jump, Numbers{1})->deviation, 0);
}

/// The bound holds, and is attained somewhere; distances have 24 bits.
TEST(BsplineControlPoints, NoPointMovesFartherThanStated) {
  std::mt19937 random(3);
  int removed_knots = 0;
  for (int trial = 0; trial < 200; ++trial) {
    const auto curve = random_curve(random, 1 + trial % 4, trial % 2 == 0);
    const double u = curve.knots[curve.span_at(inside(curve, random))];
    if (u <= curve.begin()) continue;
    const auto removed = with_knots_removed(curve, Numbers{u});
    if (!removed) continue;  // a weight would not be positive
    ++removed_knots;
    expect_part_of(curve, removed->curve, removed->deviation * (1 + 0x1p-23));
  }
  EXPECT_GT(removed_knots, 50);
}

/// (t^3)' = 3 t^2, of which the control points are products of neighbouring knots (Marsden's identity).
TEST(BsplineControlPoints, DerivativesOfPowers) {
  const Numbers u{-1, 0, 1, 2, 4, 4, 7, 9, 9, 10};
  BsplineCurve cube{1, 3, u, {}, {}};
  for (std::size_t i = 0; i < cube.points(); ++i) cube.control_points.push_back(u[i + 1] * u[i + 2] * u[i + 3]);
  const auto first = derivative_of_bspline(cube, 1);
  EXPECT_EQ(first.knots, Numbers(u.begin() + 1, u.end() - 1));
  for (std::size_t i = 0; i < first.points(); ++i) EXPECT_EQ(first.control_points[i], 3 * u[i + 2] * u[i + 3]);
  const auto second = derivative_of_bspline(cube, 2);
  for (std::size_t i = 0; i < second.points(); ++i) EXPECT_EQ(second.control_points[i], 6 * u[i + 3]);
}

/// Two parabolas without a common point, (t - 0)^2 and 5 + 2 (t - 1): slopes 0..2 and 2..2.
TEST(BsplineControlPoints, DerivativeAcrossAJump) {
  const BsplineCurve curve{1, 2, {0, 0, 0, 1, 1, 1, 2, 2, 2}, {0, 0, 1, 5, 6, 7}, {}};
  const auto slope = derivative_of_bspline(curve, 1);
  EXPECT_EQ(slope.knots, (Numbers{0, 0, 1, 1, 2, 2}));
  EXPECT_EQ(slope.control_points, (Numbers{0, 2, 2, 2}));
}

/// The quarter circle over [0, 1], in degree 3: weights 1, 1, 4/3, 2 [Piegl and Tiller 1997], section 5.5.
TEST(BsplineControlPoints, ElevatesARationalCurve) {
  const BsplineCurve quarter{2, 2, {0, 0, 0, 1, 1, 1}, {1, 0, 1, 1, 0, 1}, {1, 1, 2}};
  const auto cubic = elevated_bspline(quarter, 3);
  EXPECT_EQ(cubic->knots, (Numbers{0, 0, 0, 0, 1, 1, 1, 1}));
  EXPECT_EQ(cubic->weights, (Numbers{1, 1, 4.0 / 3, 2}));
  EXPECT_EQ(cubic->control_points, (Numbers{1, 0, 1, 2.0 / 3, 0.5, 1, 0, 1}));
}

}  // namespace

// The exact values of B-spline curves. Over any knots, the control points of t^n are the products of n neighbouring
// knots (Marsden's identity), and those of t their means.

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
