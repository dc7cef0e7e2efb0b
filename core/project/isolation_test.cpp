// SPDX-License-Identifier: MIT
// The parts of isolation: certain signs, roots from good and bad estimates, and code for one degree against code for
// any degree.
#include "core/project/isolation.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <boost/multiprecision/gmp.hpp>
#include <cmath>
#include <vector>

#include "core/evaluate/evaluation_test.hpp"

namespace bezierbench {
namespace {

using Rational = boost::multiprecision::mpq_rational;

template <int Dimension>
Curve<Form::bernstein, double, Dimension> random_curve(int n, Inputs& inputs, double grid) {
  Curve<Form::bernstein, double, Dimension> curve(n);
  for (int i = 0; i <= n; ++i)
    for (int axis = 0; axis < Dimension; ++axis) {
      const double x = inputs.symmetric();
      curve(axis, i) = grid == 0 ? x : std::floor(x / grid) * grid;
    }
  return curve;
}

template <int Dimension>
Point<double, Dimension> random_point(Inputs& inputs, double grid) {
  const auto curve = random_curve<Dimension>(0, inputs, grid);
  Point<double, Dimension> point;
  for (int axis = 0; axis < Dimension; ++axis) point[axis] = curve(axis, 0);
  return point;
}

template <int Dimension, int Degree>
void compare_with_any_degree(Inputs& inputs, double grid) {
  const auto curve = random_curve<Dimension>(Degree, inputs, grid);
  const auto point = random_point<Dimension>(inputs, grid);
  const auto own = Isolation<Dimension, Degree>(curve, point).foot();
  const auto any = Isolation<Dimension>(curve, point).foot();
  EXPECT_EQ(own.t, any.t);
  EXPECT_EQ(own.distance, any.distance);
  EXPECT_EQ(own.candidates, any.candidates);
  EXPECT_EQ(own.converged, any.converged);
}

TEST(Isolation, CodeForOneDegreeGivesTheBitsOfCodeForAny) {
  Inputs inputs(21);
  for (int trial = 0; trial < 300; ++trial) {
    const double grid = trial % 2 == 0 ? 0 : 0.25;  // 0.25 gives coinciding points, roots at the ends, ties
    compare_with_any_degree<1, 3>(inputs, grid);
    compare_with_any_degree<2, 2>(inputs, grid);
    compare_with_any_degree<2, 3>(inputs, grid);
    compare_with_any_degree<3, 3>(inputs, grid);
  }
}

/// On the parabola y = 1 - x^2, x = 2t - 1, the square of the distance from (0, c) is x^4 + (2c - 1) x^2 + (1 - c)^2.
/// For c < 1/2 it is largest at x = 0, and least where x^2 = 1/2 - c, if that is on the curve.
TEST(Isolation, CountsGreatestDistancesAndPassesThemOver) {
  Curve<Form::bernstein, double, 2> parabola(2);
  const std::array points{std::array{-1.0, 0.0}, std::array{0.0, 2.0}, std::array{1.0, 0.0}};
  for (int i = 0; i <= 2; ++i)
    for (int axis = 0; axis < 2; ++axis)
      parabola(axis, i) = points[static_cast<std::size_t>(i)][static_cast<std::size_t>(axis)];
  const auto far = Isolation<2, 2>(parabola, {0, -1}).foot();
  EXPECT_EQ(far.candidates, 3);  // both ends and the middle
  EXPECT_EQ(far.t, 0);
  const auto near = Isolation<2, 2>(parabola, {0, 0.25}).foot();
  EXPECT_EQ(near.candidates, 5);
  EXPECT_EQ(near.t, 0.25);
  const auto any_degree = Isolation<2>(parabola, {0, 0.25}).foot();
  EXPECT_EQ(any_degree.candidates, 5);
  EXPECT_EQ(any_degree.t, 0.25);
}

/// The exact differences of the coordinates on one axis from the point.
std::vector<Rational> offsets(const Curve<Form::bernstein, double, 2>& curve, const Point<double, 2>& point, int axis) {
  std::vector<Rational> result;
  for (int i = 0; i <= curve.degree(); ++i) result.push_back(Rational(curve(axis, i)) - Rational(point[axis]));
  return result;
}
std::vector<Rational> differences(const std::vector<Rational>& b) {
  std::vector<Rational> result;
  for (std::size_t i = 0; i + 1 < b.size(); ++i) result.push_back(b[i + 1] - b[i]);
  return result;
}

void halve_exactly(std::vector<Rational>& b, bool left) {
  auto level = b;
  for (std::size_t k = 0; k < b.size(); ++k) {
    (left ? b[k] : b[b.size() - 1 - k]) = left ? level.front() : level.back();
    for (std::size_t i = 0; i + 1 < level.size(); ++i) level[i] = (level[i] + level[i + 1]) / 2;
    level.pop_back();
  }
}

/// C(n,i), by Pascal's rule.
Rational choose(std::size_t n, std::size_t i) {
  return i == 0 || i == n ? Rational(1) : choose(n - 1, i - 1) + choose(n - 1, i);
}

/// Adds the product of two polynomials in Bernstein form.
void add_product(const std::vector<Rational>& a, const std::vector<Rational>& b, std::vector<Rational>& f) {
  const std::size_t m = a.size() - 1;
  const std::size_t n = b.size() - 1;
  for (std::size_t i = 0; i <= m; ++i)
    for (std::size_t j = 0; j <= n; ++j) f[i + j] += choose(m, i) * choose(n, j) / choose(m + n, i + j) * a[i] * b[j];
}

/// A piece of a curve in doubles, and the same piece in rationals.
struct TwinPiece {
  HalvedPolygon<2> offset;
  HalvedPolygon<2> difference;
  std::array<std::vector<Rational>, 2> exact_offset;
  std::array<std::vector<Rational>, 2> exact_difference;

  TwinPiece(const Curve<Form::bernstein, double, 2>& curve, const Point<double, 2>& point, const OffsetCurve<2>& seen)
      : offset(seen.offsets()), difference(seen.differences_of_points()) {
    const Rational m(seen.unscaled(1));
    for (std::size_t axis = 0; axis < 2; ++axis) {
      exact_offset[axis] = offsets(curve, point, static_cast<int>(axis));
      for (auto& x : exact_offset[axis]) x /= m;
      exact_difference[axis] = differences(exact_offset[axis]);
    }
  }
  void halve(bool left) {
    std::array<HalvedPolygon<2>, 2> both;
    bezierbench::halve(offset, both[0], both[1]);
    offset = both[left ? 0 : 1];
    bezierbench::halve(difference, both[0], both[1]);
    difference = both[left ? 0 : 1];
    for (auto& axis : exact_offset) halve_exactly(axis, left);
    for (auto& axis : exact_difference) halve_exactly(axis, left);
  }
  [[nodiscard]] std::vector<Rational> exact_product() const {
    std::vector<Rational> f(2 * exact_difference[0].size());
    for (std::size_t axis = 0; axis < 2; ++axis) add_product(exact_offset[axis], exact_difference[axis], f);
    return f;
  }
};

/// Halving towards a point on the curve makes C - P shrink until only the errors of earlier halvings are left.
TEST(PolygonProduct, IsNeverOffByMoreThanItsErrorHoweverOftenHalved) {
  Inputs inputs(22);
  double worst = 0;
  for (int trial = 0; trial < 60; ++trial) {
    const int n = 1 + trial % 5;
    const auto curve = random_curve<2>(n, inputs, 0);
    double t = inputs.unit();
    const Point<double, 2> point = OffsetCurve<2>(curve, Point<double, 2>::Zero()).at(t);  // m is mostly 1
    TwinPiece piece(curve, point, OffsetCurve<2>(curve, point));
    for (int depth = 0; depth < 40; ++depth) {
      const auto f = PolygonProduct(n)(piece.offset, piece.difference);
      const auto exact = piece.exact_product();
      for (int k = 0; k <= f.degree(); ++k) {
        const Rational off = abs(Rational(f.coefficient(k)) - exact[static_cast<std::size_t>(k)]);
        EXPECT_LE(off, Rational(f.error)) << "trial " << trial << " depth " << depth << " k " << k;
        worst = std::max(worst, Rational(off / Rational(f.error)).convert_to<double>());
      }
      piece.halve(t < 0.5);
      t = t < 0.5 ? 2 * t : 2 * t - 1;
    }
  }
  EXPECT_GT(worst, 0x1p-7);  // a far larger error bound would leave every sign open
}

/// The largest number of sign variations, by trying every choice for the uncertain signs.
int max_variations_by_trial(std::vector<int> signs, std::size_t from = 0) {
  for (std::size_t k = from; k < signs.size(); ++k)
    if (signs[k] == 0) {
      signs[k] = 1;
      const int with_plus = max_variations_by_trial(signs, k + 1);
      signs[k] = -1;
      return std::max(with_plus, max_variations_by_trial(signs, k + 1));
    }
  int variations = 0;
  for (std::size_t k = 1; k < signs.size(); ++k) variations += signs[k] != signs[k - 1] ? 1 : 0;
  return variations;
}

TEST(UncertainPolynomial, CountsTheMostVariationsOfAnyChoice) {
  Inputs inputs(23);
  for (int trial = 0; trial < 2000; ++trial) {
    const int degree = 1 + trial % 7;
    const BinomialRow<double, dynamic> binomials(degree);
    UncertainPolynomial<> f{Polygon<1>(1, degree + 1), &binomials[0], 1};
    const bool all_certain = trial % 3 == 0;
    std::vector<int> signs;
    for (int k = 0; k <= degree; ++k) {
      signs.push_back(all_certain ? (inputs.unit() < 0.5 ? -1 : 1)
                                  : static_cast<int>(std::floor(inputs.unit() * 3)) - 1);
      f.weighted[k] = binomials[k] * (signs.back() == 0 ? inputs.symmetric() : 2.0 * signs.back());
      EXPECT_EQ(f.sign(k), signs.back());
    }
    EXPECT_EQ(f.max_variations(), max_variations_by_trial(signs));
    EXPECT_EQ(f.is_unknown(), std::ranges::all_of(signs, [](int sign) { return sign == 0; }));
  }
}

/// t^n - 2^-n has the coefficients -2^-n, except for the last, 1 - 2^-n.
TEST(EstimateRoot, OfPolynomialsWithTheRootOneHalf) {
  for (int n = 1; n <= 9; ++n) {
    Polygon<1> f = Polygon<1>::Constant(1, n + 1, -std::ldexp(1.0, -n));
    f[n] += 1;
    const auto root = estimate_root(f);
    EXPECT_NEAR(root.t, 0.5, 0x1p-30) << n;
    EXPECT_LE(std::abs(root.step), 0x1p-18) << n;
    for (auto& coefficient : f.reshaped()) coefficient = -coefficient;
    EXPECT_EQ(estimate_root(f).t, root.t) << n;
  }
}

/// The root depends on the estimate and on its claimed step by no more than the rounding errors of f.
TEST(RootInBracket, FromGoodAndBadEstimates) {
  Inputs inputs(24);
  int brackets = 0;
  for (int trial = 0; trial < 400; ++trial) {
    const auto curve = random_curve<2>(3, inputs, 0);
    const OffsetCurve<2, 3> offset(curve, random_point<2>(inputs, 0));
    const double a = inputs.unit() / 2;
    const double b = a + inputs.unit() / 2;
    const bool rising = offset.slope(a).value < 0;
    if (rising == (offset.slope(b).value < 0)) continue;
    ++brackets;
    for (const double place : {0.0, 0x1p-30, 0.3, 0.5, 0.99, 1.0})
      for (const double step : {1.0, 0x1p-20, -0x1p-45, 0x1p-60}) {
        const double t = root_in_bracket(offset, a, b, rising, {a + (b - a) * place, step});
        ASSERT_GE(t, a);
        ASSERT_LE(t, b);
        const auto f = offset.slope(t);
        const double speed = std::sqrt(f.speed_squared);
        const double rounding = 0x1p-50 * (offset.scaled_distance(t) * speed + std::abs(f.derivative) * t);
        EXPECT_LE(std::abs(f.value), rounding) << "trial " << trial << " place " << place << " step " << step;
      }
  }
  EXPECT_GT(brackets, 100);
}

/// What nearest_neighbour() says, by asking both neighbours always.
template <int Dimension, int Degree>
double nearest_of_three(const OffsetCurve<Dimension, Degree>& offset, double t) {
  double best = t;
  for (const double other : {std::nextafter(t, 0.0), std::nextafter(t, 1.0)})
    if (offset.scaled_distance(other) < offset.scaled_distance(best) * (1 - 0x1p-50)) best = other;
  return best;
}

template <int Dimension>
void ask_for_neighbours(Inputs& inputs, int distance_exponent, int& moved) {
  const auto curve = random_curve<Dimension>(3, inputs, 0);
  const OffsetCurve<Dimension, 3> from_origin(curve, Point<double, Dimension>::Zero());
  const double t = inputs.unit();
  auto point = from_origin.at(t);
  for (int axis = 0; axis < Dimension; ++axis) {
    point[axis] = from_origin.unscaled(point[axis]) + std::ldexp(inputs.symmetric(), distance_exponent);
  }
  const OffsetCurve<Dimension, 3> offset(curve, point);
  const double foot = Isolation<Dimension, 3>(curve, point).foot().t;
  for (const double near : {t, foot, std::nextafter(foot, 0.0), std::nextafter(foot, 1.0)}) {
    const NearestCandidate<Dimension> candidate{near, offset.at(near), offset.scaled_distance(near), 1};
    const double right = nearest_of_three(offset, near);
    EXPECT_EQ(nearest_neighbour(offset, candidate).t, right) << "distance 2^" << distance_exponent << ", t = " << near;
    if (right != near) ++moved;
  }
}

TEST(NearestNeighbour, IsAskedWhereverItMayBeNearer) {
  Inputs inputs(25);
  int moved = 0;
  for (int trial = 0; trial < 2000; ++trial) {
    ask_for_neighbours<1>(inputs, -trial % 60, moved);
    ask_for_neighbours<2>(inputs, -trial % 60, moved);
    ask_for_neighbours<3>(inputs, -trial % 60, moved);
  }
  EXPECT_GT(moved, 1000);
}

}  // namespace
}  // namespace bezierbench
