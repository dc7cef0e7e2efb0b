// SPDX-License-Identifier: MIT
// The points of Seiler's form: those published for the cubic, exactness over rationals, and the sums in its bound.
#include "core/evaluate/methods/seiler.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "core/evaluate/methods/rational_curve_test.hpp"

namespace bezierbench {
namespace {

constexpr double u = 0x1p-53;

/// The weights of b_k in s_0, ..., s_n.
template <class Scalar>
std::vector<Scalar> weights_of(int k, int n) {
  const auto prepared = Seiler::prepare(curve_of(unit_vector<Scalar>(n, k)));
  std::vector<Scalar> weights;
  for (int j = 0; j <= n; ++j) weights.push_back(prepared.seiler(0, j));
  return weights;
}

/// s_1 = 3 b_1 - b_0 - b_3 and s_2 = 3 b_2 - b_3 - b_0, [Yuksel 2024].
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

template <class Scalar>
void expect_ends(int n) {
  std::vector<Scalar> values;
  for (int i = 0; i <= n; ++i) values.push_back(Scalar(10000) * (Scalar(i % 7) - Scalar(3.1)));
  const auto prepared = Seiler::prepare(curve_of(values));
  EXPECT_EQ(Seiler::evaluate(prepared, Scalar(0))[0], values.front()) << "n " << n;
  EXPECT_EQ(Seiler::evaluate(prepared, Scalar(1))[0], values.back()) << "n " << n;
}

TEST(Seiler, EndsAreExactUpToTheDegreesThatItStates) {
  for (const int n : {0, 1, 2, 7, 20, 90, Seiler::info.max_degree}) expect_ends<double>(n);
  for (const int n : {0, 1, 2, 7, 20, 90, Seiler::info.max_degree_float}) expect_ends<float>(n);
}

}  // namespace
}  // namespace bezierbench
