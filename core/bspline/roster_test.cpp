// SPDX-License-Identifier: MIT
// Every method for B-spline curves against the exact points and control points, and within its bound.
#include "core/bspline/roster.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <boost/multiprecision/cpp_int.hpp>
#include <boost/multiprecision/eigen.hpp>
#include <cmath>
#include <iterator>
#include <limits>
#include <vector>

#include "core/bspline/bspline.hpp"
#include "core/bspline/kernel.hpp"
#include "core/evaluate/evaluation_test.hpp"
#include "reference/companion/bspline_control_points.hpp"

namespace bezierbench {
namespace {

constexpr double u = 0x1p-53;

std::vector<double> solve(const BsplineKernel& kernel, const BsplineSpanView& span, double t) {
  std::vector<double> all(static_cast<std::size_t>(numbers_solved(kernel, span)));
  kernel.solve(span, t, all.data());
  return all;
}

std::vector<BsplineKernel> kernels(int dimension, Form form = Form::bernstein) {
  std::vector<BsplineKernel> of_form;
  std::ranges::copy_if(bspline_kernels(dimension), std::back_inserter(of_form),
                       [form](const BsplineKernel& kernel) { return kernel.info->form == form; });
  return of_form;
}

TEST(Bspline, SaysWhichKnotsBoundASpan) {
  const auto are = [](std::vector<double> knots) { return are_span_knots<double>(knots); };
  EXPECT_TRUE(are({0, 1}) && are({0, 0, 1, 1}) && are({-1, 0, 0.5, 2}));
  EXPECT_FALSE(are({}) || are({0, 1, 2})) << "not two for each degree";
  EXPECT_FALSE(are({0, 1, 1, 2})) << "an empty span";
  EXPECT_FALSE(are({0, 1, 2, 1.5}) || are({1, 0, 2, 3})) << "descending";
  EXPECT_FALSE(are({0, std::numeric_limits<double>::quiet_NaN(), 2, 3}));
}

/// The first and the last knot are 2e308 apart. The point is that of the knots over 1e308, by de Boor's algorithm in
/// fractions.
TEST(Bspline, DifferencesOfKnotsMayLeaveTheRange) {
  const std::vector<double> knots{-1e308, -1e308, 0, 1e308, 1e308, 1e308};  // of the span from 0 to 1e308
  const std::vector<double> control_points{1, 2, 3, 1, 4, 4, 6, 0.5};
  for (const auto& kernel : kernels(2)) {
    if (kernel.bound == nullptr) continue;
    const auto point = solve(kernel, {2, 3, knots, control_points}, 5e307);
    EXPECT_NEAR(point[0], 3.90625, 4e-15) << kernel.info->id;
    EXPECT_NEAR(point[1], 2.75, 4e-15) << kernel.info->id;
  }
}

TEST(Bspline, TheFirstSpanOfAClampedCurveBeginsInItsFirstPoint) {
  Inputs inputs(7);
  for (int n = 1; n <= 9; ++n) {
    std::vector<double> knots(static_cast<std::size_t>(n), 0.1);
    for (int k = 0; k < n; ++k) knots.push_back(knots.back() + inputs.unit() + 0x1p-20);
    const auto control_points = inputs.coefficients(n, 2);
    for (const auto& kernel : kernels(2)) {
      const auto all = solve(kernel, {2, n, knots, control_points}, 0.1);
      EXPECT_EQ(all[0], control_points[0]) << kernel.info->id << " degree " << n;
      EXPECT_EQ(all[1], control_points[1]) << kernel.info->id << " degree " << n;
    }
  }
}

/// A span whose Bernstein form it is already, exactly: the quarter circle with weights 1, 1, 2.
TEST(Bspline, WeightsMakeACircle) {
  const std::vector<double> knots{0, 0, 1, 1};
  const std::vector<double> control_points{1, 0, 1, 1, 0, 1};
  const std::vector<double> weights{1, 1, 2};
  for (const auto& kernel : kernels(2, Form::rational)) {
    const auto all = solve(kernel, {2, 2, knots, control_points, weights}, 0.5);
    ASSERT_EQ(all.size(), kernel.makes_bernstein ? 11U : 2U) << kernel.info->id;
    EXPECT_DOUBLE_EQ(all[0], 0.6) << kernel.info->id;  // 3/5 and 4/5: the half angle has the tangent t
    EXPECT_DOUBLE_EQ(all[1], 0.8) << kernel.info->id;
    if (!kernel.makes_bernstein) continue;
    EXPECT_EQ(std::vector(all.begin() + 2, all.begin() + 8), control_points) << kernel.info->id;
    EXPECT_EQ(std::vector(all.begin() + 8, all.end()), weights) << kernel.info->id;
  }
}

/// Knots about a span, of one of several kinds.
std::vector<double> some_knots(int kind, int n, Inputs& inputs) {
  std::vector<double> knots{kind == 0 ? 17 : inputs.unit() * (kind == 4 ? 0x1p+20 : 1)};
  for (int k = 1; k < 2 * n; ++k) {
    const double random = 0x1p-10 + inputs.unit();
    double distance = random;
    if (kind == 0) distance = 1;
    if (kind == 1 && k != n) distance = k < n ? 0 : random;
    if (kind == 2 && k != n) distance = inputs.unit() < 0.5 ? 0 : random;
    if (kind == 3) distance = std::ldexp(random, -static_cast<int>(inputs.unit() * 30));
    knots.push_back(knots.back() + distance);
  }
  if (kind == 5)
    for (double& knot : knots) knot = std::ldexp(knot, -1060);
  return knots;
}
constexpr int kinds_of_knots = 6;

/// That the error of `value` is within a bound of the method.
void expect_bound(const BsplineKernel& kernel, const BsplineBound::Part& bound, const BsplineSpanView& span,
                  const reference::ExactBsplineWeights& weights, double value, int trial) {
  std::vector<double> magnitudes;
  for (const double d : span.control_points) magnitudes.push_back(std::abs(d));
  const auto truth = weights.sum(1, span.control_points);
  const double p_tilde = reference::round_to(reference::binary64, weights.sum(1, magnitudes).coordinate(0));
  const double error = reference::Distance(truth).to(std::span(&value, 1));
  const double lost = bound.underflow(span.degree) * std::numeric_limits<double>::denorm_min() *
                      (1 + *std::ranges::max_element(magnitudes));
  EXPECT_LE(error, (bound.factor(span.degree, u) * u * p_tilde + lost) * (1 + 0x1p-20))
      << kernel.info->id << " degree " << span.degree << " trial " << trial;
}

TEST(Bspline, PointsAndControlPointsKeepTheirBounds) {
  Inputs inputs(8);
  for (int trial = 0; trial < 50 * kinds_of_knots; ++trial) {
    const int n = 1 + static_cast<int>(inputs.unit() * (trial % 25 == 0 ? 20 : 7));
    const auto knots = some_knots(trial % kinds_of_knots, n, inputs);
    const auto size = static_cast<std::size_t>(n);
    ASSERT_TRUE(are_span_knots<double>(knots));
    auto control_points = inputs.coefficients(n, 1);
    if (trial % 7 == 0)
      for (double& d : control_points) d *= 0x1p-1065;
    const double inside =
        std::clamp(knots[size - 1] + inputs.unit() * (knots[size] - knots[size - 1]), knots[size - 1], knots[size]);
    const double t = trial % 5 == 0 ? knots[size - 1] : trial % 5 == 1 ? knots[size] : inside;
    const BsplineSpanView span{1, n, knots, control_points};
    for (const auto& kernel : kernels(1)) {
      const auto all = solve(kernel, span, t);
      ASSERT_TRUE(std::ranges::all_of(all, [](double x) { return std::isfinite(x); })) << kernel.info->id;
      if (kernel.bound == nullptr) continue;
      expect_bound(kernel, kernel.bound->point, span, reference::ExactBsplineWeights::at(knots, t), all[0], trial);
      for (int k = 0; k <= n && kernel.makes_bernstein; ++k)
        expect_bound(kernel, *kernel.bound->control, span, reference::ExactBsplineWeights::of_control_point(knots, k),
                     all[static_cast<std::size_t>(k) + 1], trial);
    }
  }
}

/// Without a proved bound: over uniform and clamped knots of degrees up to 5 all but a few digits are right.
TEST(Bspline, CoefficientsByChudyAndWoznyAreRightOverOrdinaryKnots) {
  Inputs inputs(9);
  const auto& kernel = *std::ranges::find(bspline_kernels(1), &ChudyWoznySpan::info, &BsplineKernel::info);
  for (int trial = 0; trial < 60; ++trial) {
    const int n = 1 + trial % 5;
    const auto knots = some_knots(trial % 2, n, inputs);
    const auto control_points = inputs.coefficients(n, 1);
    const auto all = solve(kernel, {1, n, knots, control_points}, knots[static_cast<std::size_t>(n)]);
    for (int k = 0; k <= n; ++k) {
      const auto truth = reference::ExactBsplineWeights::of_control_point(knots, k).sum(1, control_points);
      EXPECT_LE(reference::Distance(truth).to(std::span(&all[static_cast<std::size_t>(k) + 1], 1)), 0x1p-40)
          << "degree " << n << " control point " << k;
    }
  }
}

namespace mp = boost::multiprecision;
using Rational = mp::number<mp::cpp_rational_backend, mp::et_off>;
using Numbers = std::vector<Rational>;

/// The blossom of sum q_j t^j: t^j becomes the mean of the products of j of the arguments.
Rational blossom(const Numbers& q, const Numbers& arguments) {
  Numbers symmetric(q.size(), Rational(0));  // the elementary symmetric functions
  symmetric[0] = 1;
  for (const auto& x : arguments)
    for (std::size_t j = q.size() - 1; j > 0; --j) symmetric[j] += x * symmetric[j - 1];
  Rational sum = 0;
  Rational products = 1;  // C(n,j)
  for (std::size_t j = 0; j < q.size(); ++j) {
    sum += q[j] * symmetric[j] / products;
    products = products * static_cast<int>(q.size() - 1 - j) / static_cast<int>(j + 1);
  }
  return sum;
}

Rational value(const Numbers& q, const Rational& t) { return blossom(q, Numbers(q.size() - 1, t)); }

Numbers polynomial(int n) {
  Numbers q;
  for (int j = 0; j <= n; ++j) q.push_back(Rational((7 * j * j - 11 * j + 3) % 17, 1 + j % 5));
  return q;
}

BsplineSpan<Rational, 1> span_of(const Numbers& q, const Numbers& knots) {
  const int n = static_cast<int>(q.size()) - 1;
  BsplineSpan<Rational, 1> span(knots);
  for (int i = 0; i <= n; ++i)
    span.control_points(0, i) = blossom(q, Numbers(knots.begin() + i, knots.begin() + i + n));
  return span;
}

template <class M>
void expect_polynomial(const Numbers& knots) {
  const int n = static_cast<int>(knots.size()) / 2;
  const auto q = polynomial(n);
  const auto span = span_of(q, knots);
  const Rational& a = span.begin();
  const Rational& c = span.end();
  for (const Rational& t : {a, Rational((2 * a + c) / 3), Rational((a + 6 * c) / 7), c}) {
    if constexpr (BsplineConversion<M>)
      EXPECT_EQ(point_of_span(M::convert(span), a, c, t)[0], value(q, t)) << M::info.id << " t " << t;
    else
      EXPECT_EQ(M::evaluate(span, t)[0], value(q, t)) << M::info.id << " t " << t;
  }
  if constexpr (BsplineConversion<M>) {
    const auto bernstein = M::convert(span);
    for (int k = 0; k <= n; ++k) {
      Numbers ends(static_cast<std::size_t>(n), c);
      std::fill_n(ends.begin(), n - k, a);
      EXPECT_EQ(bernstein(0, k), blossom(q, ends)) << M::info.id << " control point " << k;
    }
  }
}

template <class... Ms>
void expect_all(TypeList<Ms...> /*methods*/, const Numbers& knots) {
  (expect_polynomial<Ms>(knots), ...);
}

Rational third(int k) { return {k, 3}; }

TEST(BsplineAlgebra, EveryMethodReturnsThePolynomialOverAnyKnots) {
  expect_all(PolynomialBsplineMethods{}, {2, 5});                                             // a line
  expect_all(PolynomialBsplineMethods{}, {0, 1, 2, 3});                                       // uniform
  expect_all(PolynomialBsplineMethods{}, {0, 0, 0, 1, 2, 5});                                 // clamped
  expect_all(PolynomialBsplineMethods{}, {3, 3, 3, 4, 4, 4});                                 // Bernstein form
  expect_all(PolynomialBsplineMethods{}, {-7, third(-5), third(-5), 1, third(4), 6, 6, 80});  // a double knot
  expect_all(PolynomialBsplineMethods{},
             {-9, -4, -4, -4, third(1), third(2), third(2), third(2), 5, 7});  // triple knots
  expect_all(PolynomialBsplineMethods{}, {-1, -1, -1, -1, -1, 0, Rational(1, 1 << 20), 1, 1, 1, 1, 1000000});  // uneven
}

}  // namespace

}  // namespace bezierbench
