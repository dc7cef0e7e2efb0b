// SPDX-License-Identifier: MIT
#include "core/api/evaluate.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <complex>
#include <random>
#include <vector>

#include "core/api/floating_point.hpp"
#include "reference/error/trial_scale.hpp"
#include "reference/exact.hpp"

namespace bezierbench {
namespace {

using testing::ElementsAre;

template <class Scalar, std::size_t Dimension>
std::vector<std::array<Scalar, Dimension>> random_points(int degree, unsigned seed) {
  std::mt19937 words(seed);
  std::vector<std::array<Scalar, Dimension>> points(static_cast<std::size_t>(degree) + 1);
  for (auto& point : points)
    for (auto& coordinate : point) coordinate = static_cast<Scalar>(static_cast<double>(words()) * 0x1p-20 - 2048);
  return points;
}

const std::vector<std::array<double, 2>> quadratic{{0, 0}, {1, 2}, {3, 1}};

TEST(Evaluate, TakesEveryContiguousRangeOfArrays) {
  const std::array<std::array<double, 2>, 3> fixed{{{0, 0}, {1, 2}, {3, 1}}};
  const std::array<double, 2> c_array[] = {{0, 0}, {1, 2}, {3, 1}};
  const auto expected = ElementsAre(0.5625, 0.8125);  // (1-t)^2 b_0 + 2 t (1-t) b_1 + t^2 b_2 at t = 1/4
  EXPECT_THAT(evaluate(quadratic, 0.25), expected);
  EXPECT_THAT(evaluate(fixed, 0.25), expected);
  EXPECT_THAT(evaluate(c_array, 0.25), expected);
  EXPECT_THAT(evaluate(std::span(quadratic), 0.25), expected);
  EXPECT_THAT((evaluate(std::span<const std::array<double, 2>, 3>(fixed), 0.25)), expected);
}

TEST(Evaluate, TakesPowerFormAndRationalCurves) {
  EXPECT_THAT(evaluate<Form::power>(quadratic, 0.5), ElementsAre(1.25, 1.25));  // q_0 + q_1 / 2 + q_2 / 4
  EXPECT_THAT(evaluate<Horner>(quadratic, 0.5), ElementsAre(1.25, 1.25));
  const std::array<std::array<double, 2>, 3> corner{{{1, 0}, {1, 1}, {0, 2}}};
  const std::array<double, 3> weights{1, 1, 2};  // ((1-t^2, 2t) / (1+t^2)): a quarter of the unit circle
  EXPECT_THAT(evaluate(std::array<std::array<double, 2>, 3>{{{1, 0}, {1, 1}, {0, 1}}}, weights, 0.5),
              ElementsAre(0.6, 0.8));
  EXPECT_THAT(evaluate<DeCasteljauFarin>(corner, weights, 1), ElementsAre(0, 2));
}

struct OneMore {  // the dual number value + slope e with e^2 = 0
  double value = 0;
  double slope = 0;

  OneMore() = default;
  explicit OneMore(double constant, double of_slope = 0) : value(constant), slope(of_slope) {}
  friend OneMore operator+(OneMore a, OneMore b) { return OneMore(a.value + b.value, a.slope + b.slope); }
  friend OneMore operator-(OneMore a, OneMore b) { return OneMore(a.value - b.value, a.slope - b.slope); }
  friend OneMore operator*(OneMore a, OneMore b) {
    return OneMore(a.value * b.value, a.value * b.slope + a.slope * b.value);
  }
};

TEST(Evaluate, TakesScalarsThatOnlyAddAndMultiply) {
  const std::vector<std::array<OneMore, 1>> points{{OneMore(0)}, {OneMore(1)}, {OneMore(3)}};
  const auto point = evaluate(points, OneMore(0.25, 1));
  EXPECT_EQ(point[0].value, 0.5625);
  EXPECT_EQ(point[0].slope, 2.5);  // p' = 2 ((1-t)(b_1 - b_0) + t (b_2 - b_1))
  const std::vector<std::array<std::complex<double>, 1>> complex{{0.0}, {1.0}, {3.0}};
  EXPECT_EQ(evaluate(complex, std::complex<double>(0, 1))[0], std::complex<double>(-1, 2));  // 2t + t^2 at t = i
  const std::vector<std::array<long double, 1>> wide{{0.0L}, {1.0L}, {3.0L}};
  EXPECT_EQ(evaluate(wide, 0.25L)[0], 0.5625L);
}

TEST(Evaluate, ChoosesAsTheRuleSays) {
  EXPECT_EQ(recommended(2).id, "de_casteljau");
  EXPECT_EQ(recommended(3).id, "horner_bernstein");
  EXPECT_EQ(recommended(512).id, "horner_bernstein");
  EXPECT_EQ(recommended(513).id, "de_casteljau");
  EXPECT_EQ((recommended<Form::bernstein, float>(64).id), "horner_bernstein");
  EXPECT_EQ((recommended<Form::bernstein, float>(65).id), "de_casteljau");
  EXPECT_EQ(recommended<Form::power>(8).id, "horner");
  EXPECT_EQ(recommended<Form::power>(9).id, "estrin");
  EXPECT_EQ(recommended<Form::rational>(3).id, "horner_bernstein");
}

TEST(Evaluate, ChoosesNothingThatOverflowsForCoordinatesOfUsualSize) {
  for (const int degree : {60, 64, 65, 100, 131, 1000}) {
    const std::vector<std::array<float, 1>> single(static_cast<std::size_t>(degree) + 1, {1e18F});
    const std::vector<std::array<double, 1>> points(single.size(), {1e150});
    EXPECT_NEAR(evaluate(single, 0.5F)[0], 1e18F, 1e14F) << degree;
    EXPECT_NEAR(evaluate(points, 0.5)[0], 1e150, 1e140) << degree;
  }
}

/// The point has the bits of the method that the rule names.
template <class Method, class Points>
bool is_by(const Points& points, ScalarOf<Points> t) {
  return recommended<Form::bernstein, ScalarOf<Points>>(degree_of_points(points)).id == Method::info.id &&
         evaluate(points, t) == evaluate<Method>(points, t);
}

TEST(Evaluate, HasTheBitsOfTheMethodItChose) {
  EXPECT_TRUE(is_by<DeCasteljau>(random_points<double, 3>(2, 1), 0.3));
  EXPECT_TRUE(is_by<HornerBernstein>(random_points<double, 3>(17, 2), 0.3));
  EXPECT_TRUE(is_by<HornerBernstein>(random_points<double, 3>(17, 3), 1.3));
  EXPECT_TRUE(is_by<HornerBernstein>(random_points<float, 2>(9, 4), 0.3F));
  const auto points = random_points<double, 2>(9, 5);
  EXPECT_EQ(prepare<VolkSchumaker>(points)(0.7), evaluate<VolkSchumaker>(points, 0.7));
}

TEST(Evaluate, RefusesWhatIsNoCurve) {
  const std::vector<std::array<double, 2>> none;
  EXPECT_THROW(evaluate(none, 0.5), std::invalid_argument);
  EXPECT_THROW(evaluate(random_points<double, 1>(max_degree + 1, 1), 0.5), std::invalid_argument);
  EXPECT_THROW(evaluate<HornerBernstein>(random_points<float, 1>(132, 1), 0.5F), std::invalid_argument);
  EXPECT_THROW(evaluate(quadratic, std::vector<double>{1, 1}, 0.5), std::invalid_argument);
}

/// The bound that studies hold errors to. reference::TrialScale computes it without the code of error_bound().
double bound_of_harness(const MethodInfo& info, Form form, std::span<const double> coefficients, double t) {
  reference::TrialScale scale;
  scale.set({form, 1, static_cast<int>(coefficients.size()) - 1, coefficients, {}}, t);
  return scale.least_bound(*info.bound, reference::double_arithmetic);
}

template <class Method>
void expect_the_bound_of_the_harness() {
  for (const int degree : {2, 3, 20, 60})
    for (const double t : {0.0, 0x1p-40, 0.3, 1.0, -0.5, 2.5}) {
      const auto points = random_points<double, 1>(degree, static_cast<unsigned>(degree));
      std::vector<double> coefficients;
      for (const auto& point : points) coefficients.push_back(point[0]);
      const double expected = bound_of_harness(Method::info, Method::info.form, coefficients, t);
      const double bound = error_bound<Method>(points, t)[0];
      if (std::isfinite(expected)) {
        EXPECT_NEAR(bound / expected, 1 + 0x1p-20, 0x1p-30) << Method::info.id << ", degree " << degree << ", t " << t;
      } else {
        EXPECT_EQ(bound, expected) << Method::info.id << ", degree " << degree << ", t " << t;
      }
    }
}

TEST(ErrorBound, IsThatOfTheHarness) {
  expect_the_bound_of_the_harness<DeCasteljau>();
  expect_the_bound_of_the_harness<CompensatedDeCasteljau>();
  expect_the_bound_of_the_harness<Horner>();
  expect_the_bound_of_the_harness<Via<Differences, Horner>>();
  expect_the_bound_of_the_harness<Via<PositiveSum, DeCasteljau>>();
  expect_the_bound_of_the_harness<Local<HornerBernsteinFma>>();
  expect_the_bound_of_the_harness<LocalOrBernstein>();
}

TEST(ErrorBound, HoldsForWhatEvaluateChooses) {
  for (unsigned seed = 0; seed < 200; ++seed) {
    const int degree = static_cast<int>(seed % 40);
    const auto points = random_points<double, 2>(degree, seed);
    const auto single = random_points<float, 2>(degree, seed);
    const double t = -0.5 + 0.01 * seed;
    const auto error = exact_error(points, t, evaluate(points, t));
    const auto error_single = exact_error(single, static_cast<float>(t), evaluate(single, static_cast<float>(t)));
    for (std::size_t axis = 0; axis < 2; ++axis) {
      EXPECT_LE(error[axis], error_bound(points, t)[axis]) << "degree " << degree << ", t " << t;
      EXPECT_LE(error_single[axis], error_bound(single, static_cast<float>(t))[axis]) << "degree " << degree;
    }
  }
}

/// Curves of degree 12 whose control points differ by at most 2^-29 of their distance from the origin: rounding the
/// result is nearly all that is left, although power form amplifies coefficients by 3^12.
TEST(ErrorBound, OfAPathThatCountsFromTheStartIsThatOfTheResultOnDistantCurves) {
  auto points = random_points<double, 2>(12, 1);
  for (auto& point : points)
    for (auto& coordinate : point) coordinate = 0x1p31 + coordinate * 0x1p-10;
  for (const double t : {0.0, 0.25, 1.0}) {
    const auto error = exact_error(points, t, evaluate<Via<Differences, Horner>>(points, t));
    const auto bound = error_bound<Via<Differences, Horner>>(points, t);
    for (std::size_t axis = 0; axis < 2; ++axis) {
      EXPECT_LE(error[axis], bound[axis]);
      EXPECT_LT(bound[axis], 1.1 * 0x1p-53 * 0x1p31);
    }
  }
}

TEST(ErrorBound, IsInfiniteWhereNothingIsProved) {
  EXPECT_EQ(error_bound<WoznyChudy>(quadratic, 0.5)[0], std::numeric_limits<double>::infinity());
}

TEST(FloatingPoint, IsKeptInThisBuild) { EXPECT_TRUE(keeps_arithmetic()); }

}  // namespace
}  // namespace bezierbench
