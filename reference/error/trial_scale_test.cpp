// SPDX-License-Identifier: MIT
#include "reference/error/trial_scale.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>

#include "core/bound/amplification.hpp"
#include "core/evaluate/homogeneous.hpp"
#include "core/evaluate/methods/compensated_volk_schumaker.hpp"
#include "core/evaluate/methods/de_casteljau.hpp"
#include "core/evaluate/methods/horner_bernstein.hpp"
#include "core/evaluate/methods/volk_schumaker.hpp"

namespace bezierbench::reference {

namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();

TEST(TrialScale, TakesEuclideanNormsOfCoefficients) {
  const std::vector<double> line{3, 4, -6, 8};  // norms 5 and 10
  TrialScale scale;
  scale.set({Form::bernstein, 2, 1, line}, 0.25);
  EXPECT_DOUBLE_EQ(scale.p_tilde(), 5 * 0.75 + 10 * 0.25);
  scale.set({Form::power, 2, 1, line}, 0.25);
  EXPECT_DOUBLE_EQ(scale.p_tilde(), 5 + 10 * 0.25);
  scale.set({Form::bernstein, 2, 1, line}, -1);
  EXPECT_DOUBLE_EQ(scale.p_tilde(), 5 * 2 + 10 * 1);
}

TEST(TrialScale, IsScaleInvariant) {
  for (const double size : {1e-300, 1e-160, 1.0, 1e160, 1e300}) {
    const std::vector<double> curve{3 * size, 4 * size, 0, size, -6 * size, 8 * size};
    TrialScale scale;
    scale.set({Form::bernstein, 2, 2, curve}, 0.5);
    EXPECT_NEAR(scale.p_tilde() / size, (5 + 2 * 1 + 10) / 4.0, 1e-14) << size;
  }
}

TEST(TrialScale, BoundUnitsFollowTheDefinition) {
  const std::vector<double> zero{0, 0};
  const std::vector<double> one{1, 1};
  TrialScale scale;
  scale.set({Form::bernstein, 1, 1, zero}, 0.5);
  EXPECT_EQ(scale.in_bound_units(0, double_arithmetic), 0);
  EXPECT_EQ(scale.in_bound_units(1e-300, double_arithmetic), infinite);
  scale.set({Form::bernstein, 1, 1, one}, 0.5);
  EXPECT_EQ(scale.in_bound_units(0x1p-53, double_arithmetic), 1);
  EXPECT_EQ(scale.in_bound_units(0x1p-22, float_arithmetic), 4);
}

TEST(TrialScale, BoundAddsRoundingAndUnderflow) {
  const std::vector<double> one{1, 1, 1};
  const ErrorBound rounding{"", Amplification::p_tilde_bernstein, [](int n, double) { return 3.0 * n; },
                            [](int) { return 0.0; }, false};
  const ErrorBound underflow{"", Amplification::p_tilde_bernstein, [](int, double) { return 0.0; },
                             [](int n) { return 5.0 * n; }, true};
  TrialScale scale;
  scale.set({Form::bernstein, 1, 2, one}, 0.5);
  EXPECT_EQ(scale.bound(rounding, double_arithmetic), 6 * 0x1p-53);
  EXPECT_EQ(scale.bound(underflow, double_arithmetic), 10 * 2 * 0x1p-1074);  // S = 1 + max|c| = 2
  scale.set({Form::bernstein, 1, 2, one}, 2);                                // (x + y)^n = 9
  EXPECT_EQ(scale.bound(underflow, double_arithmetic), 10 * 2 * 9 * 0x1p-1074);
}

TEST(TrialScale, BoundCountsTheResultsRoundingsInUnitsOfTheGivenFormsPTilde) {
  const std::vector<double> line{3, 4, -6, 8};  // norms 5 and 10
  ErrorBound bound{"", Amplification::bernstein_to_power, [](int, double) { return 3.0; }, [](int) { return 0.0; },
                   false};
  bound.result_roundings = 2;
  TrialScale scale;
  scale.set({Form::bernstein, 2, 1, line}, 0.5);  // p~ = 7.5, amplification 5 * 1.5 + 10 * 0.5
  EXPECT_DOUBLE_EQ(scale.bound(bound, double_arithmetic), (2 * 7.5 + 3 * 12.5) * 0x1p-53);
}

template <class Method>
double bound_at_the_middle(int degree, const std::vector<double>& points, const std::vector<double>& weights = {}) {
  TrialScale scale;
  scale.set({Method::info.form, 1, degree, points, weights}, 0.5);
  return scale.bound(*Method::info.bound, double_arithmetic);
}

/// C(20,10) 1e304 leaves the range, and so do 2^2 1.7e308, w_i b_i of 1e310 and C(20,10) w_i of 1e311.
TEST(TrialScale, NothingIsProvedWhereAResultMayOverflow) {
  const std::vector<double> huge(21, 1e304);
  const std::vector<double> ones(21, 1.0);
  EXPECT_EQ(bound_at_the_middle<HornerBernstein>(20, huge), infinite);
  EXPECT_EQ(bound_at_the_middle<VolkSchumaker>(20, huge), infinite);
  EXPECT_TRUE(std::isfinite(bound_at_the_middle<HornerBernstein>(20, ones)));
  EXPECT_TRUE(std::isfinite(bound_at_the_middle<DeCasteljau>(20, huge)));
  EXPECT_EQ(bound_at_the_middle<CompensatedVolkSchumaker>(2, {1.7e308, 1.7e308, 1.7e308}), infinite);
  EXPECT_EQ(bound_at_the_middle<Homogeneous<DeCasteljau>>(1, {1e300, 1e300}, {1e10, 1e10}), infinite);
  const std::vector<double> heavy(21, 1e306);
  EXPECT_EQ(bound_at_the_middle<Homogeneous<HornerBernstein>>(20, ones, heavy), infinite);
  EXPECT_TRUE(std::isfinite(bound_at_the_middle<Homogeneous<DeCasteljau>>(20, ones, heavy)));
}

/// |(1.68, 1.32)| 1e308 is beyond the largest double: a sum with it is not the sum of the others.
TEST(TrialScale, ANormBeyondTheRangeIsNotDropped) {
  const std::vector<double> line{1e308, 0, 1.68e308, 1.32e308};
  TrialScale scale;
  scale.set({Form::bernstein, 2, 1, line}, 0.5);
  EXPECT_EQ(scale.p_tilde(), infinite);
}

/// By hand: weights 1, 1, 2 and points of norm 5, 10, 1 at t = 1/2; sum w B = 5/4, sum w |b| B = (5 + 20 + 2) / 4.
TEST(TrialScale, OfRationalCurvesDividesByTheSumOfTheWeights) {
  const std::vector<double> c{3, 4, -6, 8, 0, 1};
  const std::vector<double> w{1, 1, 2};
  TrialScale scale;
  scale.set({Form::rational, 2, 2, c, w}, 0.5);
  EXPECT_DOUBLE_EQ(scale.p_tilde(), 27.0 / 5);
  // 1 - 2t at t = 1/4 and 3/4: magnitudes above, the signed sum below
  const std::vector<double> ones{1, 1};
  const std::vector<double> signs{1, -1};
  for (const double t : {0.25, 0.75}) {
    scale.set({Form::rational, 1, 1, ones, signs}, t);
    EXPECT_DOUBLE_EQ(scale.p_tilde(), 2);
  }
  // (1 + 2t - 2t^2) at t = 2 is -3, cancelled from 1 - 8 + 4; magnitudes 1 + 8 + 4
  const std::vector<double> three_ones{1, 1, 1};
  const std::vector<double> middle{1, 2, 1};
  scale.set({Form::rational, 1, 2, three_ones, middle}, 2);
  EXPECT_DOUBLE_EQ(scale.p_tilde(), 13.0 / 3);
}

TEST(TrialScale, BoundOfRationalCurvesAddsUnderflowOverTheSumOfTheWeights) {
  ErrorBound bound{"", Amplification::p_tilde_bernstein, [](int, double) { return 0.0; }, [](int) { return 4.0; },
                   true};
  bound.unit_interval_only = true;
  const std::vector<double> c{1, 1};
  const std::vector<double> w{2, 6};
  TrialScale scale;
  scale.set({Form::rational, 1, 1, c, w}, 0.5);  // the sum is 4, p~ = 1, max |w b| = max w = 6
  EXPECT_EQ(scale.bound(bound, double_arithmetic), (1 + 4 * (7 + 7 * 1) / 4) * 0x1p-1074);
  bound.positive_weights_only = true;
  EXPECT_EQ(scale.bound(bound, double_arithmetic), (1 + 4 * (1 + 1) * (1 + 6) / 2) * 0x1p-1074);
}

/// Each condition of the proof, one after the other.
TEST(TrialScale, BoundOfRationalCurvesHasConditions) {
  ErrorBound bound{"", Amplification::p_tilde_bernstein, [](int, double) { return 1.0; }, [](int) { return 5.0; },
                   false};
  bound.unit_interval_only = true;
  const std::vector<double> c{1, 1};
  TrialScale scale;
  const auto with = [&](const std::vector<double>& w, double t) {
    scale.set({Form::rational, 1, 1, c, w}, t);
    return scale.bound(bound, double_arithmetic);
  };
  EXPECT_TRUE(std::isfinite(with({1, 2}, 0.5)));
  EXPECT_EQ(with({1, 2}, 1.25), infinite);
  EXPECT_EQ(with({1, -0.5}, 0.5), infinite);
  EXPECT_TRUE(std::isfinite(with({1, 0}, 0.5)));
  EXPECT_EQ(with({1, 0}, 1), infinite);                    // no weight is left
  EXPECT_EQ(with({0x1p-1070, 0x1p-1070}, 0.5), infinite);  // underflow may be 5/16 of the sum
  EXPECT_TRUE(std::isfinite(with({0x1p-1068, 0x1p-1068}, 0.5)));
  EXPECT_TRUE(std::isfinite(with({1, 0x1p+1000}, 0.5)));
  EXPECT_EQ(with({1, std::numeric_limits<double>::max()}, 0.5), infinite);  // the roundings of w_i b_i may overflow
  bound.positive_weights_only = true;
  EXPECT_TRUE(std::isfinite(with({1, 2}, 0.5)));
  EXPECT_EQ(with({1, 0}, 0.5), infinite);
}

TEST(TrialScale, ViolationNeedsMoreThanTheSlack) {
  EXPECT_FALSE(TrialScale::violates(1, 1));
  EXPECT_FALSE(TrialScale::violates(1 + 0x1p-21, 1));
  EXPECT_TRUE(TrialScale::violates(1 + 0x1p-19, 1));
  EXPECT_FALSE(TrialScale::violates(1, infinite));
}

/// The closed forms that are derived in core/bound/amplification.hpp against the double sums they come from.
TEST(Amplification, EqualsTheMatricesItStandsFor) {
  constexpr std::size_t n = 9;
  const auto binomial = [](std::size_t a, std::size_t b) {
    double result = 1;
    for (std::size_t k = 1; k <= b; ++k) result = result * static_cast<double>(a - b + k) / static_cast<double>(k);
    return result;
  };
  std::vector<double> c;
  for (std::size_t i = 0; i <= n; ++i) c.push_back(static_cast<double>(1 + (7 * i) % 5));
  for (const double t : {0.0, 0.1, 0.5, 0.9, 1.0, -0.5, 2.0}) {
    const double x = std::abs(t);
    const double y = std::abs(1 - t);
    std::vector<double> power(n + 1, 0);      // |M| c: magnitudes of the power coefficients
    std::vector<double> bernstein(n + 1, 0);  // M^-1 c
    for (std::size_t j = 0; j <= n; ++j)
      for (std::size_t i = 0; i <= j; ++i) {
        power[j] += binomial(n, j) * binomial(j, i) * c[i];
        bernstein[j] += binomial(j, i) / binomial(n, i) * c[i];
      }
    std::vector<double> forth(n + 1, 0);  // M^-1 |M| M^-1 c
    std::vector<double> between(n + 1, 0);
    for (std::size_t j = 0; j <= n; ++j)
      for (std::size_t i = 0; i <= j; ++i) between[j] += binomial(n, j) * binomial(j, i) * bernstein[i];
    for (std::size_t j = 0; j <= n; ++j)
      for (std::size_t i = 0; i <= j; ++i) forth[j] += binomial(j, i) / binomial(n, i) * between[i];
    double to_power = 0;
    double to_bernstein = 0;
    double solve = 0;
    for (std::size_t i = 0; i <= n; ++i) {
      const double basis =
          binomial(n, i) * integer_power(x, static_cast<int>(i)) * integer_power(y, static_cast<int>(n - i));
      to_power += power[i] * integer_power(x, static_cast<int>(i));
      to_bernstein += bernstein[i] * basis;
      solve += forth[i] * basis;
    }
    EXPECT_NEAR(amplification(Amplification::bernstein_to_power, c, t) / to_power, 1, 1e-13) << t;
    EXPECT_NEAR(amplification(Amplification::power_to_bernstein, c, t) / to_bernstein, 1, 1e-13) << t;
    EXPECT_NEAR(amplification(Amplification::forward_substitution, c, t) / solve, 1, 1e-13) << t;
  }
}

/// By hand, for the quadratic 100, 101, 103: the differences are 0, 1, 3 from the start and 3, 2, 0 from the end.
TEST(Amplification, OfTheSpreadCountsFromTheNearerEnd) {
  const std::vector<double> line{100, 101, 103};
  const auto amplified = [&](Amplification kind, double t) {
    ErrorBound bound{"", kind, [](int, double) { return 1.0; }, [](int) { return 0.0; }};
    TrialScale scale;
    scale.set({Form::bernstein, 1, 2, line}, t);
    return scale.bound(bound, double_arithmetic) * 0x1p53;
  };
  EXPECT_DOUBLE_EQ(amplified(Amplification::spread, 0.25), 1 * 2 * 0.25 * 0.75 + 3 * 0.0625);
  EXPECT_DOUBLE_EQ(amplified(Amplification::spread, 0.5), 1 * 0.5 + 3 * 0.25);
  EXPECT_DOUBLE_EQ(amplified(Amplification::spread, 0.75), 2 * 2 * 0.25 * 0.75 + 3 * 0.0625);
  EXPECT_DOUBLE_EQ(amplified(Amplification::spread_to_power, 0.25), 1 * 2 * 0.25 * 1.25 + 3 * 0.0625);
  EXPECT_DOUBLE_EQ(amplified(Amplification::spread_to_power, 0.75), 2 * 2 * 0.25 * 1.25 + 3 * 0.0625);
  EXPECT_DOUBLE_EQ(amplified(Amplification::spread_to_power_from_start, 0.75), 1 * 2 * 0.75 * 1.75 + 3 * 0.5625);
}

/// (1/2 + z)^n sum c_i C(n,i) against C(n,j) M^(n-j) (1 + E)^j c_0 built step by step, and against the magnitudes of
/// the true coefficients about 1/2, which it bounds.
TEST(Amplification, OfTheCentredFormIsThatOfDifferencesAndMidpoints) {
  constexpr std::size_t n = 9;
  std::vector<double> c;
  for (std::size_t i = 0; i <= n; ++i) c.push_back(static_cast<double>(1 + (7 * i) % 5));
  const auto first_after = [](std::vector<double> values, std::size_t pairings, double weight) {
    for (std::size_t k = 0; k < pairings; ++k) {
      for (std::size_t i = 0; i + 1 < values.size(); ++i) values[i] = weight * (values[i] + values[i + 1]);
      values.pop_back();
    }
    return values;
  };
  for (const double t : {0.0, 0.1, 0.5, 0.9, 1.0, -0.5, 2.0}) {
    const double z = std::abs(t - 0.5);
    double steps = 0;
    double binomial = 1;
    for (std::size_t j = 0; j <= n; ++j) {
      const double coefficient = binomial * first_after(first_after(c, j, 1), n - j, 0.5)[0];
      steps += coefficient * integer_power(z, static_cast<int>(j));
      binomial = binomial * static_cast<double>(n - j) / static_cast<double>(j + 1);
    }
    // sum_i c_i C(n,i) |coefficients of (1/2+s)^i (1/2-s)^(n-i)| z^j
    double magnitudes = 0;
    double binomial_n = 1;
    for (std::size_t i = 0; i <= n; ++i) {
      std::vector<double> product{1};
      for (std::size_t k = 0; k < n; ++k) {
        const double slope = k < i ? 1 : -1;
        product.push_back(0);
        for (std::size_t j = product.size() - 1; j > 0; --j) product[j] = 0.5 * product[j] + slope * product[j - 1];
        product[0] *= 0.5;
      }
      for (std::size_t j = 0; j <= n; ++j)
        magnitudes += c[i] * binomial_n * std::abs(product[j]) * integer_power(z, static_cast<int>(j));
      binomial_n = binomial_n * static_cast<double>(n - i) / static_cast<double>(i + 1);
    }
    const double closed = amplification(Amplification::bernstein_to_centered, c, t);
    EXPECT_NEAR(closed / steps, 1, 1e-13) << t;
    EXPECT_LE(magnitudes, closed * (1 + 1e-13)) << t;
  }
  const std::vector<double> equal(21, 1.0);
  for (const double t : {0.0, 0.25, 0.5, 1.0})
    EXPECT_NEAR(amplification(Amplification::bernstein_to_centered, equal, t) / std::pow(1 + 2 * std::abs(t - 0.5), 20),
                1, 1e-13);
  EXPECT_DOUBLE_EQ(amplification(Amplification::p_tilde_centered, std::vector<double>{1, 2, 3}, 0.25),
                   1 + 2 * 0.25 + 3 * 0.0625);
}

/// p~ dominated by one tiny or huge term: nothing may underflow or overflow on the way to a normal number.
TEST(Amplification, KeepsTermsOfVeryDifferentSize) {
  std::vector<double> last(401, 0.0);
  last.back() = 1e308;
  EXPECT_NEAR(amplification(Amplification::p_tilde_bernstein, last, 0.1) / 1e-92, 1, 1e-12);
  std::vector<double> mixed(31, 0.0);
  mixed[0] = 1.25e-290;
  mixed[30] = 1e300;  // times t^30: vanishes beside the first
  EXPECT_NEAR(amplification(Amplification::p_tilde_bernstein, mixed, 1e-30) / 1.25e-290, 1, 1e-12);
  std::vector<double> cubic(151, 0.0);
  cubic[3] = 1;
  EXPECT_NEAR(amplification(Amplification::p_tilde_power, cubic, 1e3) / 1e9, 1, 1e-12);
  EXPECT_EQ(amplification(Amplification::power_to_bernstein, cubic, 1e3), infinite);  // 1e9 1999^147
}

}  // namespace

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

TEST(CoordinateError, IsMeasuredInEveryUnit) {
  const Rational third{1, 3, 0};  // p~ is 1/3, too: errors over it are relative
  const auto judged = coordinate_error(0.25, third, third);
  EXPECT_EQ(judged.exact, 1.0 / 3);
  EXPECT_EQ(judged.error, 1.0 / 12);
  EXPECT_EQ(judged.error_ulp, 1.0 / 12 * 0x1p+54);  // 1/3 lies in [2^-2, 2^-1)
  EXPECT_EQ(judged.error_u, 0x1p+51);
}

TEST(CoordinateError, OfAValueWithoutScale) {
  const Rational zero;
  EXPECT_EQ(coordinate_error(0, zero, zero).error_u, 0);
  EXPECT_EQ(coordinate_error(1, zero, zero).error_u, infinity);
  EXPECT_EQ(coordinate_error(0x1p-1074, zero, zero).error_ulp, 1);
  for (const double lost : {infinity, std::numeric_limits<double>::quiet_NaN()}) {
    const auto judged = coordinate_error(lost, exactly(2), exactly(2));
    EXPECT_EQ(judged.exact, 2);
    EXPECT_EQ(judged.error, infinity);
    EXPECT_EQ(judged.error_ulp, infinity);
    EXPECT_EQ(judged.error_u, infinity);
  }
}

TEST(CoordinateBound, IsThatOfTheAxis) {
  const ErrorBound bound{.text = "3 p~",
                         .amplification = Amplification::p_tilde_bernstein,
                         .factor = [](int, double) { return 3.0; },
                         .underflow = [](int) { return 0.0; }};
  constexpr std::array coefficients{1.0, 16.0, -3.0, 16.0};  // p~ at t = 1/2 is 2 in x, 16 in y
  const CurveView<double> curve{Form::bernstein, 2, 1, coefficients, {}};
  const double x = coordinate_bound(bound, curve, 0, 0.5, exactly(-1));
  const double y = coordinate_bound(bound, curve, 1, 0.5, exactly(16));
  EXPECT_NEAR(x, 6 * 0x1p-53, 0x1p-70);
  EXPECT_NEAR(y, 48 * 0x1p-53, 0x1p-67);
  EXPECT_NEAR(*bound_units(y, exactly(16)), 3, 0x1p-20);
}

TEST(CoordinateBound, HasNoUnitsWhereNothingIsProved) {
  EXPECT_FALSE(bound_units(infinity, exactly(1)));
  EXPECT_FALSE(bound_units(1, Rational{}));
}

}  // namespace

}  // namespace bezierbench::reference
