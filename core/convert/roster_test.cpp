// SPDX-License-Identifier: MIT
#include "core/convert/roster.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <string>
#include <vector>

#include "core/evaluate/via.hpp"
#include "reference/exact_curve.hpp"

namespace bezierbench {
namespace {

template <class... Cs>
testing::Types<Cs...> test_types(TypeList<Cs...>);
using AllConversions = decltype(test_types(typename GivenTargets<Conversions>::Type{}));

template <class C>
std::vector<double> convert_axis(const std::vector<double>& in) {
  const int n = static_cast<int>(in.size()) - 1;
  Curve<C::info.form, double, 1> curve(n);
  for (int i = 0; i <= n; ++i) curve(0, i) = in[static_cast<std::size_t>(i)];
  const auto converted = C::convert(curve);
  std::vector<double> out;
  for (int i = 0; i <= n; ++i) out.push_back(converted(0, i));
  return out;
}

template <class C>
class ConversionTest : public testing::Test {};
TYPED_TEST_SUITE(ConversionTest, AllConversions);

/// One axis of a worked conversion.
struct Worked {
  std::vector<double> bernstein;
  std::vector<double> power;
};

/// The five worked conversions that [Report 001] prints (section 2.2), axis by axis.
const std::vector<Worked> printed{
    {{0, 1}, {0, 1}},
    {{0, 1}, {0, 1}},  // (0,0) (1,1)
    {{1, 4}, {1, 3}},
    {{3, 5}, {3, 2}},  // (1,3) (4,5)
    {{0, 1, 2}, {0, 2, 0}},
    {{0, 1, 0}, {0, 2, -2}},  // (0,0) (1,1) (2,0)
    {{1, 3, 5}, {1, 4, 0}},
    {{2, 4, 6}, {2, 4, 0}},  // (1,2) (3,4) (5,6)
    {{0, 1, 2, 3}, {0, 3, 0, 0}},
    {{0, 1, 1, 0}, {0, 3, -3, 0}},  // (0,0) (1,1) (2,1) (3,0)
};

TYPED_TEST(ConversionTest, GivesTheWorkedConversionsOfTheReportExactly) {
  for (const auto& [bernstein, power] : printed) {
    const bool to_power = TypeParam::info.form == Form::bernstein;
    EXPECT_EQ(convert_axis<TypeParam>(to_power ? bernstein : power), to_power ? power : bernstein);
  }
}

/// b_i = q_0 for every i: C(i,j) (i-j+1) leaves the range from degree 1021 on, C(n,i) does not.
TEST(PositiveSum, KeepsAConstantUpToTheLargestDegree) {
  for (const int n : {1000, 1001, 1021, PositiveSum::info.max_degree}) {
    std::vector<double> constant(static_cast<std::size_t>(n) + 1, 0.0);
    constant[0] = 1;
    EXPECT_THAT(convert_axis<PositiveSum>(constant), testing::Each(1.0)) << n;
  }
}

TYPED_TEST(ConversionTest, KeepsDegreeZeroAndTheFirstCoefficient) {
  EXPECT_THAT(convert_axis<TypeParam>({0.7}), testing::ElementsAre(0.7));
  std::vector<double> ramp(171);
  for (std::size_t i = 0; i < ramp.size(); ++i) ramp[i] = 1.0 / static_cast<double>(i + 3);
  EXPECT_EQ(convert_axis<TypeParam>(ramp)[0], ramp[0]);
}

TYPED_TEST(ConversionTest, IsNearTheExactCoefficients) {
  std::mt19937_64 words(1);
  for (const int n : {1, 2, 3, 5, 10, 15}) {
    std::vector<double> in;
    for (int i = 0; i <= n; ++i) in.push_back(static_cast<double>(static_cast<std::int64_t>(words())) * 0x1p-63);
    const auto out = convert_axis<TypeParam>(in);
    const auto truth = reference::converted({TypeParam::info.form, 1, n, in});
    // Every conversion here amplifies by at most 9^n: 3^n in the coefficients, 3^n again in a signed solve.
    for (std::size_t i = 0; i < out.size(); ++i)
      EXPECT_LE(reference::Distance(truth[i]).to(std::span(&out[i], 1)), 8 * (n + 5) * 0x1p-53 * std::pow(9, n))
          << TypeParam::info.id << " n " << n << " coefficient " << i;
  }
}

/// Inputs that have broken conversions: subnormal, huge, cancelling, mixed, zero.
const std::vector<std::vector<double>> nasty{
    {0x1p-1074, -0x1p-1074, 0x1.8p-1073},
    {1e308, -1e308, 1e308, 5e307},
    {1e300, 1e-300, -1e300, 1},
    {0, 0, 0, 0},
    {-0.0, 3, -0.0},
    {1 + 0x1p-52, 1, 1 - 0x1p-53, 1},
    {0x1p-1022, 0x1.fffffffffffffp-1023, -0x1p-1050, 7},
};

template <class C>
void expect_correctly_rounded(const std::vector<double>& in) {
  const auto out = convert_axis<C>(in);
  const auto truth = reference::converted({C::info.form, 1, static_cast<int>(in.size()) - 1, in});
  for (std::size_t i = 0; i < in.size(); ++i)
    EXPECT_EQ(out[i], reference::round_to(reference::binary64, truth[i].coordinate(0))) << C::info.id << " " << i;
}

TEST(ExactConversion, RoundsCorrectly) {
  auto cases = nasty;
  std::mt19937_64 words(2);
  for (const int n : {1, 4, 20, 50, 170}) {
    cases.emplace_back();
    for (int i = 0; i <= n; ++i)
      cases.back().push_back(std::ldexp(static_cast<double>(static_cast<std::int64_t>(words())) * 0x1p-63,
                                        static_cast<int>(words() % 100) - 50));
  }
  for (const auto& in : cases) {
    expect_correctly_rounded<ExactToPower>(in);
    expect_correctly_rounded<ExactToBernstein>(in);
  }
}

std::vector<std::vector<double>> nasty_and_random() {
  auto cases = nasty;
  std::mt19937_64 words(3);
  for (const int n : {0, 1, 4, 20, 50}) {
    cases.emplace_back();
    for (int i = 0; i <= n; ++i)
      cases.back().push_back(std::ldexp(static_cast<double>(static_cast<std::int64_t>(words())) * 0x1p-63,
                                        static_cast<int>(words() % 100) - 50));
  }
  return cases;
}

TEST(ExactConversion, DoubleDoubleHoldsTheRoundedCoefficientAndTheRoundedRest) {
  for (const auto& in : nasty_and_random()) {
    const auto truth = reference::converted({Form::bernstein, 1, static_cast<int>(in.size()) - 1, in});
    std::vector<double> high(in.size());
    std::vector<double> low(in.size());
    exact_to_power_double_double(in, high, low, RoundTo::binary64);
    for (std::size_t j = 0; j < in.size(); ++j) {
      const auto q = truth[j].coordinate(0);
      EXPECT_EQ(high[j], reference::round_to(reference::binary64, q));
      const double rest =
          std::isfinite(high[j]) ? reference::round_to(reference::binary64, q - reference::exactly(high[j])) : 0;
      EXPECT_EQ(low[j], rest) << in.size() << " " << j;
    }
    exact_to_power_double_double(in, high, low, RoundTo::binary32);
    for (std::size_t j = 0; j < in.size(); ++j) {
      const auto q = truth[j].coordinate(0);
      EXPECT_EQ(high[j], reference::round_to(reference::binary32, q));
      const double rest =
          std::isfinite(high[j]) ? reference::round_to(reference::binary32, q - reference::exactly(high[j])) : 0;
      EXPECT_EQ(low[j], rest) << in.size() << " " << j;
    }
  }
}

/// The true coefficients about t = 1/2, from the true power coefficients: c_j = sum_(k>=j) C(k,j) q_k 2^(j-k).
std::vector<reference::Rational> true_centred(const std::vector<double>& in) {
  const auto q = reference::converted({Form::bernstein, 1, static_cast<int>(in.size()) - 1, in});
  std::vector<reference::Rational> centred(in.size());
  for (std::size_t j = 0; j < in.size(); ++j) {
    mpz_class binomial = 1;
    for (std::size_t k = j; k < in.size(); ++k) {
      centred[j] = centred[j] +
                   q[k].coordinate(0) * reference::Rational{binomial, 1, static_cast<long>(j) - static_cast<long>(k)};
      binomial =
          binomial * mpz_class(static_cast<unsigned long>(k + 1)) / mpz_class(static_cast<unsigned long>(k + 1 - j));
    }
  }
  return centred;
}

TEST(ExactConversion, CentredRoundsCorrectly) {
  for (const auto& in : nasty_and_random()) {
    const auto truth = true_centred(in);
    std::vector<double> out(in.size());
    exact_to_power_centered(in, out, RoundTo::binary64);
    for (std::size_t j = 0; j < in.size(); ++j)
      EXPECT_EQ(out[j], reference::round_to(reference::binary64, truth[j])) << in.size() << " " << j;
  }
}

/// Coefficient by coefficient: gamma_(n+1) C(n,j) 2^j M^n |b|, where M^n |b| <= max |b|; for n = 60 with 60 more.
TEST(CentredConversion, DifferencesKeepTheirBoundInEachCoefficient) {
  std::mt19937_64 words(5);
  for (const int n : {1, 2, 3, 8, 20, 60}) {
    std::vector<double> in;
    for (int i = 0; i <= n; ++i) in.push_back(static_cast<double>(static_cast<std::int64_t>(words())) * 0x1p-63);
    const auto out = convert_axis<DifferencesCentered>(in);
    const auto truth = true_centred(in);
    double weight = 1;  // C(n,j) 2^j
    for (int j = 0; j <= n; ++j) {
      const auto k = static_cast<std::size_t>(j);
      const double error =
          reference::round_to(reference::binary64, reference::abs(truth[k] - reference::exactly(out[k])));
      EXPECT_LE(error, DifferencesCentered::info.bound->factor(n, 0x1p-53) * 0x1p-53 * weight) << n << " " << j;
      weight = weight * 2 * (n - j) / (j + 1);
    }
  }
}

TEST(ExactConversion, RoundsOnceIntoFloat) {
  // 1 + 2^-24 + 2^-60 is above the tie between 1 and 1 + 2^-23: rounding to double first would fall on the tie.
  const std::vector<double> power{1 + 0x1p-24, 0x1p-54};  // b_1 = 1 + 2^-24 + 2^-54
  std::vector<double> bernstein(2);
  exact_to_bernstein(power, bernstein, RoundTo::binary32);
  EXPECT_EQ(bernstein[1], 1 + 0x1p-23);
}

/// Texts show the operands and the order of every step.
TEST(NeighbourLevels, AreThoseOfTheDefinition) {
  const auto combine = [](const std::string& here, const std::string& before) { return "(" + here + before + ")"; };
  for (int n = 0; n <= 9; ++n) {
    std::vector<std::string> expected;
    for (int i = 0; i <= n; ++i) expected.push_back(std::to_string(i));
    auto found = expected;
    const auto at = [&](int i) -> std::string& { return found[static_cast<std::size_t>(i)]; };
    combine_neighbours(at, n, combine);
    for (std::size_t k = 1; k < expected.size(); ++k)
      for (std::size_t i = expected.size() - 1; i >= k; --i) expected[i] = combine(expected[i], expected[i - 1]);
    EXPECT_EQ(found, expected) << n;
  }
}

}  // namespace

}  // namespace bezierbench
