// SPDX-License-Identifier: MIT
#include "reference/exact_curve.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

#include "reference/rational_test.hpp"

namespace bezierbench::reference {
namespace {

Rational power(const Rational& base, int exponent) {
  Rational result{1, 1, 0};
  for (int k = 0; k < exponent; ++k) result = result * base;
  return result;
}

/// The definition, term by term with rationals: another route than the homogeneous Horner scheme under test.
Rational definition(Form form, const std::vector<double>& c, double t) {
  const int n = static_cast<int>(c.size()) - 1;
  const Rational one{1, 1, 0};
  Rational sum;
  mpz_class binomial;
  for (int i = 0; i <= n; ++i) {
    mpz_bin_uiui(binomial.get_mpz_t(), static_cast<unsigned long>(n), static_cast<unsigned long>(i));
    const Rational coefficient = exactly(c[static_cast<std::size_t>(i)]);
    const Rational basis = form == Form::power
                               ? power(exactly(t), i)
                               : Rational{binomial, 1, 0} * power(exactly(t), i) * power(one - exactly(t), n - i);
    sum = sum + basis * coefficient;
  }
  return sum;
}

const std::vector<double> nasty_t{
    0,      1,    0.5, 1.0 / 3, 1 - 0x1p-53, 0x1p-1074,   -0x1p-1074,
    1e-300, -2.5, 3.7, 1e300,   -1e300,      1 + 0x1p-52, std::numeric_limits<double>::max()};
const std::vector<std::vector<double>> nasty_c{
    {3.25},
    {0, 0, 0},
    {-0.0, 1},
    {0x1p-1074, -0x1p-1074, 0x1p-1070},
    {1e308, -1e308, 1e308, -1e308},
    {1e308, 1e-308, -0x1p-1074, 1},
    {1, -1, 1, -1, 1, -1, 1},
    {0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7, 0.8, 0.9},
};

TEST(ExactCurve, IsTheDefinitionOnNastyInputs) {
  ExactCurve exact;
  for (const Form form : {Form::bernstein, Form::power})
    for (const auto& c : nasty_c)
      for (const double t : nasty_t) {
        const CurveView<double> curve{form, 1, static_cast<int>(c.size()) - 1, c};
        EXPECT_TRUE(same(exact.point(curve, t).coordinate(0), definition(form, c, t)))
            << name(form) << " degree " << curve.degree << " t " << t;
        std::vector<double> magnitudes;
        for (const double value : c) magnitudes.push_back(std::abs(value));
        if (t < 0 || t > 1) continue;  // inside, the basis is positive, so p~ is the curve of the magnitudes
        EXPECT_TRUE(same(exact.p_tilde(curve, t).coordinate(0), definition(form, magnitudes, t)));
      }
}

const std::vector<std::vector<double>> nasty_weights{
    {1, 1, 1, 1, 1, 1, 1, 1, 1},
    {0x1p+60, 0x1p-60, 1, 3, 0x1p-60, 0x1p+60, 0.1, 1, 7},
    {1, 0, 0, 2, 0, 1, 0, 0, 1},
    {1, -0.5, 2, -3, 1, -0.25, 1, 1, 1},
    {-1, -2, -0.25, -3, -1, -1, -5, -0.125, -1},
    {0x1p-1074, 1e308, 0x1p-1074, -1e308, 1, 1e-300, 1, 1, 1e308},
};

/// numerator / denominator = point, without dividing.
TEST(ExactCurve, OfRationalCurvesIsTheDefinitionOnNastyInputs) {
  ExactCurve exact;
  for (const auto& weights : nasty_weights)
    for (const auto& c : nasty_c)
      for (const double t : nasty_t) {
        const std::vector<double> w(weights.begin(), weights.begin() + static_cast<std::ptrdiff_t>(c.size()));
        const int n = static_cast<int>(c.size()) - 1;
        Rational numerator;
        Rational magnitudes;
        Rational denominator;
        for (int i = 0; i <= n; ++i) {
          const auto k = static_cast<std::size_t>(i);
          std::vector<double> unit(c.size(), 0.0);
          unit[k] = 1;
          const Rational basis = definition(Form::bernstein, unit, t);
          denominator = denominator + exactly(w[k]) * basis;
          numerator = numerator + exactly(w[k]) * exactly(c[k]) * basis;
          magnitudes = magnitudes + abs(exactly(w[k]) * exactly(c[k]) * basis);
        }
        const CurveView<double> curve{Form::rational, 1, n, c, w};
        const auto& point = exact.point(curve, t);
        ASSERT_EQ(point.exists(), denominator.numerator != 0);
        if (!point.exists()) continue;
        EXPECT_GT(point.denominator, 0);
        EXPECT_TRUE(same(point.coordinate(0) * denominator, numerator)) << "degree " << n << " t " << t;
        EXPECT_TRUE(same(exact.p_tilde(curve, t).coordinate(0) * abs(denominator), magnitudes))
            << "degree " << n << " t " << t;
      }
}

TEST(ExactCurve, OfRationalCurvesHasNoPointWhereTheWeightsSumToZero) {
  const std::vector<double> c{1, 2};
  const std::vector<double> w{1, -3};  // 1 - 4t
  ExactCurve exact;
  EXPECT_FALSE(exact.point({Form::rational, 1, 1, c, w}, 0.25).exists());
  EXPECT_TRUE(exact.point({Form::rational, 1, 1, c, w}, 0.5).exists());
  EXPECT_TRUE(exact.point({Form::bernstein, 1, 1, c}, 0.25).exists());
}

/// 1 / (1 + t) is rational with the products w_i b_i = 1, 1. Its derivatives are (-1)^k k! / (1 + t)^(k+1).
TEST(ExactCurve, DerivativesOfARationalCurveAreThoseOfAHyperbola) {
  const std::vector<double> c{1, 0.5};
  const std::vector<double> w{1, 2};
  ExactCurve exact;
  Rational factorial{1, 1, 0};
  for (int k = 0; k <= 12; ++k) {
    if (k > 0) factorial = factorial * Rational{-k, 1, 0};
    for (const double t : {0.0, 0.375, 1.0, -7.5, 0x1p-40}) {
      const Rational value = exact.derivative({Form::rational, 1, 1, c, w}, k, t).coordinate(0);
      EXPECT_TRUE(same(value * power(Rational{1, 1, 0} + exactly(t), k + 1), factorial)) << "order " << k << " t " << t;
    }
  }
  EXPECT_FALSE(exact.derivative({Form::rational, 1, 1, c, w}, 2, -1).exists());
  // S_1 = (2 + W~' S_0) / W with S_0 = 1 / W and W~' = 1 + 2.
  EXPECT_TRUE(
      same(exact.derivative_p_tilde({Form::rational, 1, 1, c, w}, 1, 0.5).coordinate(0) * exactly(2.25), exactly(6)));
}

/// A^(k) = sum C(k,i) W^(i) C^(k-i), with A and W as polynomial curves. The numbers have few bits: products are exact.
TEST(ExactCurve, DerivativesOfRationalCurvesSatisfyTheProductRule) {
  std::mt19937_64 words(5);
  const auto small = [&words] { return static_cast<double>(static_cast<std::int64_t>(words() % 2001) - 1000) / 64; };
  ExactCurve exact;
  for (int trial = 0; trial < 60; ++trial) {
    const int n = 1 + trial % 6;
    std::vector<double> c;
    std::vector<double> w;
    std::vector<double> products;
    for (int i = 0; i <= n; ++i) {
      c.push_back(small());
      w.push_back(small());
      products.push_back(c.back() * w.back());
    }
    const double t = small() / 16;
    std::vector<Rational> derivatives;
    for (int k = 0; k <= n + 2; ++k) {
      const auto& derivative = exact.derivative({Form::rational, 1, n, c, w}, k, t);
      ASSERT_TRUE(derivative.exists());
      derivatives.push_back(derivative.coordinate(0));
      Rational sum;
      mpz_class binomial;
      for (int i = 0; i <= k; ++i) {
        mpz_bin_uiui(binomial.get_mpz_t(), static_cast<unsigned long>(k), static_cast<unsigned long>(i));
        sum = sum + Rational{binomial, 1, 0} * exact.derivative({Form::bernstein, 1, n, w}, i, t).coordinate(0) *
                        derivatives[static_cast<std::size_t>(k - i)];
      }
      EXPECT_TRUE(same(sum, exact.derivative({Form::bernstein, 1, n, products}, k, t).coordinate(0)))
          << "degree " << n << " order " << k;
    }
  }
}

TEST(ExactCurve, KeepsAxesApart) {
  const std::vector<double> c{1, 10, 2, 20, 3, 50};
  ExactCurve exact;
  const auto& point = exact.point({Form::bernstein, 2, 2, c}, 0.25);
  EXPECT_EQ(round_to(binary64, point.coordinate(0)), 1.5);
  EXPECT_EQ(round_to(binary64, point.coordinate(1)), 10 * 0.5625 + 20 * 0.375 + 50 * 0.0625);
}

TEST(ExactCurve, PTildeOutsideTheUnitIntervalTakesMagnitudesOfTheBasis) {
  const std::vector<double> c{1, -1};  // at t = 2: |1||1-2| + |-1||2| = 3
  ExactCurve exact;
  EXPECT_EQ(round_to(binary64, exact.p_tilde({Form::bernstein, 1, 1, c}, 2).coordinate(0)), 3);
}

TEST(ExactConversion, GivesTheSameCurve) {
  std::mt19937_64 words(3);
  ExactCurve exact;
  for (const Form form : {Form::bernstein, Form::power})
    for (const int n : {0, 1, 2, 5, 12}) {
      std::vector<double> c;
      for (int i = 0; i <= n; ++i) c.push_back(static_cast<double>(static_cast<std::int64_t>(words())) * 0x1p-63);
      const CurveView<double> curve{form, 1, n, c};
      const auto converted_curve = converted(curve);
      const double t = 0.3;
      Rational sum;
      mpz_class binomial;
      for (int i = 0; i <= n; ++i) {
        mpz_bin_uiui(binomial.get_mpz_t(), static_cast<unsigned long>(n), static_cast<unsigned long>(i));
        const Rational basis = form == Form::bernstein ? power(exactly(t), i)
                                                       : Rational{binomial, 1, 0} * power(exactly(t), i) *
                                                             power(Rational{1, 1, 0} - exactly(t), n - i);
        sum = sum + basis * converted_curve[static_cast<std::size_t>(i)].coordinate(0);
      }
      EXPECT_TRUE(same(sum, exact.point(curve, t).coordinate(0))) << name(form) << " " << n;
    }
}

/// Every distance must be the one that the integers give.
double slow_distance(const ExactPoint& exact, const std::vector<double>& point) {
  Rational sum;
  for (int axis = 0; axis < exact.dimension; ++axis) {
    const Rational d = exactly(point[static_cast<std::size_t>(axis)]) - exact.coordinate(axis);
    sum = sum + d * d;
  }
  return square_root(error_format, sum);
}

TEST(Distance, EqualsTheIntegersEverywhere) {
  std::mt19937_64 words(4);
  ExactCurve exact;
  const auto random = [&] { return static_cast<double>(static_cast<std::int64_t>(words())) * 0x1p-63; };
  const std::vector<int> scales{0, 20, -900, 900, -1010, 1000};
  int checked = 0;
  for (int repeat = 0; repeat < 4000; ++repeat) {
    const int n = static_cast<int>(words() % 12);
    const int dimension = 1 + static_cast<int>(words() % 3);
    const int scale = scales[words() % scales.size()];
    std::vector<double> c;
    for (int i = 0; i < (n + 1) * dimension; ++i) c.push_back(std::ldexp(random(), scale));
    std::vector<double> w;
    for (int i = 0; i <= n; ++i) w.push_back(std::ldexp(1.5 + random(), static_cast<int>(words() % 120) - 60));
    const double t = repeat % 5 == 0 ? nasty_t[words() % 9] : std::abs(random());
    CurveView<double> curve{repeat % 2 == 0 ? Form::bernstein : Form::power, dimension, n, c};
    if (repeat % 3 == 0) curve = {Form::rational, dimension, n, c, w};
    const auto& point = exact.point(curve, t);
    if (!point.exists()) continue;
    bool in_range = true;
    for (int axis = 0; axis < dimension; ++axis)
      in_range = in_range && std::isfinite(2 * round_to(binary64, point.coordinate(axis)));
    if (!in_range) continue;  // computed points are finite, so are the truths that they are compared with here
    const Distance distance(point);
    std::vector<double> near(static_cast<std::size_t>(dimension));
    for (int variant = 0; variant < 5; ++variant) {
      for (int axis = 0; axis < dimension; ++axis) {
        const double rounded = round_to(binary64, point.coordinate(axis));
        const double direction = words() % 2 == 0 ? 1e308 : -1e308;
        near[static_cast<std::size_t>(axis)] = variant == 0   ? rounded
                                               : variant == 1 ? std::nextafter(rounded, direction)
                                               : variant == 2 ? rounded * (1 + 1e-9 * random())
                                               : variant == 3 ? 0
                                                              : std::ldexp(random(), scales[words() % scales.size()]);
      }
      EXPECT_EQ(distance.to(near), slow_distance(point, near)) << "repeat " << repeat << " variant " << variant;
      ++checked;
    }
  }
  EXPECT_GE(checked, 15000);
}

TEST(Distance, FromAPointInDouble) {
  const std::vector<double> origin{1, 2};
  const Distance distance{std::span<const double>(origin)};
  EXPECT_EQ(distance.to(std::vector<double>{4, 6}), 5);
  EXPECT_EQ(distance.to(origin), 0);
  const std::vector<double> tiny{0x1p-1074, 0};
  const Distance from_tiny{std::span<const double>(tiny)};
  EXPECT_EQ(from_tiny.to(std::vector<double>{0, 0}), 0x1p-1074);
  const std::vector<double> huge{1e308, -1e308};
  const Distance from_huge{std::span<const double>(huge)};
  EXPECT_EQ(from_huge.to(std::vector<double>{0, std::numeric_limits<double>::quiet_NaN()}),
            std::numeric_limits<double>::infinity());
  EXPECT_EQ(from_huge.to(std::vector<double>{-1e308, 1e308}), std::numeric_limits<double>::infinity());
}

/// The derivative of the power form, term by term with rationals.
Rational derivative_of_powers(const std::vector<ExactPoint>& q, int order, double t) {
  Rational sum;
  for (int j = order; j < static_cast<int>(q.size()); ++j) {
    mpz_class factor = 1;
    for (int m = 0; m < order; ++m) factor *= j - m;
    sum = sum + q[static_cast<std::size_t>(j)].coordinate(0) * Rational{factor, 1, 0} * power(exactly(t), j - order);
  }
  return sum;
}

TEST(ExactDerivative, OfTheBernsteinFormIsThatOfTheConvertedCurve) {
  ExactCurve exact;
  for (const auto& c : nasty_c) {
    const CurveView<double> curve{Form::bernstein, 1, static_cast<int>(c.size()) - 1, c};
    const auto q = converted(curve);
    for (int order = 0; order <= curve.degree + 1; ++order)
      for (const double t : nasty_t)
        EXPECT_TRUE(same(exact.derivative(curve, order, t).coordinate(0), derivative_of_powers(q, order, t)))
            << c.size() << " " << order << " " << t;
  }
}

TEST(ExactDerivative, OfThePowerFormIsThatOfItsPowers) {
  ExactCurve exact;
  for (const auto& c : nasty_c) {
    std::vector<ExactPoint> q;
    for (const double value : c) q.push_back(exactly(std::span(&value, 1)));
    const CurveView<double> curve{Form::power, 1, static_cast<int>(c.size()) - 1, c};
    for (int order = 0; order <= curve.degree + 1; ++order)
      for (const double t : nasty_t)
        EXPECT_TRUE(same(exact.derivative(curve, order, t).coordinate(0), derivative_of_powers(q, order, t)))
            << c.size() << " " << order << " " << t;
  }
}

/// Control points of the hodographs as [Document 000] prints them for (1,1) (3,1) (4,2) (6,3).
TEST(ExactDerivative, HasTheCoefficientsOfTheWorkedExample) {
  ExactCurve exact;
  const std::vector<double> points{1, 1, 3, 1, 4, 2, 6, 3};
  const CurveView<double> curve{Form::bernstein, 2, 3, points};
  EXPECT_EQ(exact.derivative_coefficients(curve, 1), (std::vector<double>{6, 0, 3, 3, 6, 3}));
  EXPECT_EQ(exact.derivative_coefficients(curve, 2), (std::vector<double>{-6, 6, 6, 0}));
  EXPECT_EQ(exact.derivative_coefficients(curve, 3), (std::vector<double>{12, -6}));
  EXPECT_EQ(exact.derivative_coefficients(curve, 4), (std::vector<double>{0, 0}));
  const auto& p_tilde = exact.derivative_p_tilde(curve, 2, 0.5);
  EXPECT_EQ(round_to(binary64, p_tilde.coordinate(0)), 6);
  EXPECT_EQ(round_to(binary64, p_tilde.coordinate(1)), 3);
}

}  // namespace
}  // namespace bezierbench::reference
