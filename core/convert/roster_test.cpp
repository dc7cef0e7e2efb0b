// SPDX-License-Identifier: MIT
#include "core/convert/roster.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "reference/exact_conversion.hpp"

namespace bezierbench {
namespace {

template <class... Cs>
testing::Types<Cs...> test_types(TypeList<Cs...>);
using AllConversions = decltype(test_types(Conversions{}));

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

/// The five worked conversions that the source report prints (seed report 001, section 2.2), axis by axis.
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

TEST(ExactConversion, RoundsOnceIntoFloat) {
  // 1 + 2^-24 + 2^-60 is above the tie between 1 and 1 + 2^-23: rounding to double first would fall on the tie.
  const std::vector<double> power{1 + 0x1p-24, 0x1p-54};  // b_1 = 1 + 2^-24 + 2^-54
  std::vector<double> bernstein(2);
  exact_to_bernstein(power, bernstein, RoundTo::binary32);
  EXPECT_EQ(bernstein[1], 1 + 0x1p-23);
}

}  // namespace
}  // namespace bezierbench
