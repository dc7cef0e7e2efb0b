// SPDX-License-Identifier: MIT
// The conversion to Wang-Ball form: exact over rationals, nothing cancels in its weights, and the bound it allows.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "core/evaluate/methods/rational_curve_test.hpp"
#include "core/evaluate/methods/seiler.hpp"
#include "core/evaluate/methods/wang_ball.hpp"

namespace bezierbench {

namespace {

constexpr double u = 0x1p-53;

Rational power(const Rational& base, int exponent) { return integer_power<Rational>(base, exponent); }

/// The definition of the basis ([Phien and Dejdumrong 2000]).
Rational basis_function(int n, int i, const Rational& t) {
  if (2 * i > n) return basis_function(n, n - i, 1 - t);
  return i < n / 2 ? Rational(power(2 * t, i) * power(1 - t, i + 2)) : Rational(power(2 * t, i) * power(1 - t, n - i));
}

TEST(WangBall, EvaluatesItsBasis) {
  for (int n = 0; n <= 9; ++n)
    for (int i = 0; i <= n; ++i)
      for (const Rational& t : {Rational(0), Rational(1, 3), Rational(5, 7), Rational(1), Rational(-3, 2)}) {
        const WangBall::Prepared<Rational, 1, dynamic> prepared{curve_of(unit_vector<Rational>(n, i))};
        EXPECT_EQ(WangBall::evaluate(prepared, t)[0], basis_function(n, i, t)) << "n " << n << " i " << i << " t " << t;
      }
}

TEST(WangBall, IsDeCasteljauWhenNothingRounds) { expect_de_casteljau_when_nothing_rounds<WangBall>(); }

/// Ball's cubic ([Ball 1974]): b_1 = (v_0 + 2 v_1)/3, b_2 = (2 v_2 + v_3)/3.
TEST(WangBall, TheCubicIsBalls) {
  const auto prepared = WangBall::prepare(curve_of<double>({2, 4, 10, 6}));
  EXPECT_EQ(prepared.ball(0, 0), 2);
  EXPECT_EQ(prepared.ball(0, 1), 5);
  EXPECT_EQ(prepared.ball(0, 2), 12);
  EXPECT_EQ(prepared.ball(0, 3), 6);
}

/// Each weight of b_k in v_i is right to the roundings of S (n+1) and of C(n,k), and two products.
TEST(WangBall, NothingCancelsInItsWeights) {
  for (const int n : {1, 2, 7, 20, 33, 50, 53}) {
    const double allowed = gamma_over_u(n + 3, u) * u;
    for (int k = 0; k <= n; ++k) {
      const auto computed = WangBall::prepare(curve_of(unit_vector<double>(n, k)));
      const auto exact = WangBall::prepare(curve_of(unit_vector<Rational>(n, k)));
      for (int i = 0; i <= n; ++i)
        EXPECT_LE(abs(Rational(computed.ball(0, i)) - exact.ball(0, i)), Rational(allowed) * abs(exact.ball(0, i)))
            << "n " << n << " k " << k << " i " << i;
    }
  }
}

TEST(WangBall, KeepsTheBoundOfItsOwnAmplification) {
  std::mt19937_64 words(1);
  for (const int n : {0, 1, 2, 3, 8, 20, 41, 50}) {
    std::vector<decltype(WangBall::prepare(curve_of<Rational>({0})))> weights;
    for (int k = 0; k <= n; ++k) weights.push_back(WangBall::prepare(curve_of(unit_vector<Rational>(n, k))));
    for (const double t : {0x1p-20, 0.2, 0.5, 0.7, static_cast<double>(words() >> 11U) * 0x1p-53}) {
      std::vector<double> values;
      std::vector<Rational> exact_values;
      for (int i = 0; i <= n; ++i) {
        values.push_back(static_cast<double>(static_cast<std::int64_t>(words())) * 0x1p-63);
        exact_values.emplace_back(values.back());
      }
      Rational amplification = 0;
      for (int i = 0; i <= n; ++i) {
        Rational sum = 0;
        for (int k = 0; k <= n; ++k)
          sum += abs(weights[static_cast<std::size_t>(k)].ball(0, i) * exact_values[static_cast<std::size_t>(k)]);
        amplification += sum * basis_function(n, i, Rational(t));
      }
      const double computed = WangBall::evaluate(WangBall::prepare(curve_of(values)), t)[0];
      const Rational exact = DeCasteljau::evaluate(curve_of(exact_values), Rational(t))[0];
      EXPECT_LE(abs(Rational(computed) - exact), Rational(gamma_over_u(5 * n + 5, u) * u) * amplification)
          << "n " << n << " t " << t;
    }
  }
}

/// The prepared curve of degree n, evaluated at its ends, which are values that round.
template <class Method, class Scalar>
auto with_exact_ends(int n, Scalar scale) {
  std::vector<Scalar> values;
  for (int i = 0; i <= n; ++i) values.push_back(scale * (Scalar(i % 7) - Scalar(3.1)));
  auto prepared = Method::prepare(curve_of(values));
  EXPECT_EQ(Method::evaluate(prepared, Scalar(0))[0], values.front()) << "n " << n;
  EXPECT_EQ(Method::evaluate(prepared, Scalar(1))[0], values.back()) << "n " << n;
  return prepared;
}

template <class Scalar>
void expect_finite_with_exact_ends(int n) {
  const auto prepared = with_exact_ends<WangBall>(n, Scalar(1));
  for (int i = 0; i <= n; ++i) EXPECT_TRUE(std::isfinite(prepared.ball(0, i))) << "n " << n << " i " << i;
}

TEST(WangBall, EndsAreExactUpToTheDegreesThatItStates) {
  for (const int n : {0, 1, 2, 7, 20, 90, WangBall::info.max_degree}) expect_finite_with_exact_ends<double>(n);
  for (const int n : {0, 1, 2, 7, 20, 90, WangBall::info.max_degree_float}) expect_finite_with_exact_ends<float>(n);
}

// The points of Seiler's form: those published for the cubic, exactness over rationals, and the sums in its bound.

/// The weights of b_k in s_0, ..., s_n.
template <class Scalar>
std::vector<Scalar> weights_of(int k, int n) {
  const auto prepared = Seiler::prepare(curve_of(unit_vector<Scalar>(n, k)));
  std::vector<Scalar> weights;
  for (int j = 0; j <= n; ++j) weights.push_back(prepared.seiler(0, j));
  return weights;
}

/// The inner points of Seiler's cubic are s_1 = 3 b_1 - b_0 - b_3 and s_2 = 3 b_2 - b_3 - b_0 [Yuksel 2024].
TEST(Seiler, TheCubicHasThePublishedPoints) {
  EXPECT_THAT(weights_of<double>(0, 3), testing::ElementsAre(1, -1, -1, 0));
  EXPECT_THAT(weights_of<double>(1, 3), testing::ElementsAre(0, 3, 0, 0));
  EXPECT_THAT(weights_of<double>(2, 3), testing::ElementsAre(0, 0, 3, 0));
  EXPECT_THAT(weights_of<double>(3, 3), testing::ElementsAre(0, -1, -1, 1));
}

TEST(Seiler, IsDeCasteljauWhenNothingRounds) { expect_de_casteljau_when_nothing_rounds<Seiler>(); }

/// S has at most n roundings; C(n,k) up to n = 54 none.
TEST(Seiler, NothingCancelsInItsWeights) {
  for (const int n : {1, 2, 7, 20, 33, 50, 54})
    for (int k = 0; k <= n; ++k) {
      const auto computed = weights_of<double>(k, n);
      const auto exact = weights_of<Rational>(k, n);
      for (std::size_t j = 0; j < exact.size(); ++j)
        EXPECT_LE(abs(Rational(computed[j]) - exact[j]), Rational(gamma_over_u(n + 1, u) * u) * abs(exact[j]))
            << "n " << n << " k " << k << " j " << j;
    }
}

/// The sum of all magnitudes at t = 1/2, where they are largest against C(n,k) max(t, 1-t)^n, for every degree.
TEST(Seiler, ItsWeightsAddUpToWhatTheBoundSays) {
  for (const int n : {1, 2, 3, 4, 5, 10, 21, 40, 77}) {
    Rational binomial = 1;
    for (int k = 0; k <= n; ++k) {
      const auto weights = weights_of<Rational>(k, n);
      Rational sum = 0;
      Rational power_of_z = 1;  // 4^-j
      for (int j = 0; 2 * j <= n; ++j) {
        const Rational& own = weights[static_cast<std::size_t>(j)];
        const Rational& mirrored = weights[static_cast<std::size_t>(n - j)];
        sum += power_of_z * (abs(own) + abs(mirrored)) / 2;
        power_of_z /= 4;
      }
      const auto factor = static_cast<double>(sum / binomial) * std::pow(2, n);
      EXPECT_LE(factor, std::pow(1 + std::sqrt(2.0), n)) << "n " << n << " k " << k;
      binomial = binomial * (n - k) / (k + 1);
    }
  }
}

TEST(Seiler, EndsAreExactUpToTheDegreesThatItStates) {
  for (const int n : {0, 1, 2, 7, 20, 90, Seiler::info.max_degree}) with_exact_ends<Seiler>(n, 10000.0);
  for (const int n : {0, 1, 2, 7, 20, 90, Seiler::info.max_degree_float}) with_exact_ends<Seiler>(n, 10000.0F);
}

}  // namespace

}  // namespace bezierbench
