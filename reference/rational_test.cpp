// SPDX-License-Identifier: MIT
#include "reference/rational.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <random>
#include <vector>

#include "reference/exact_point.hpp"

namespace bezierbench::reference {

namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();

/// numerator / denominator 2^exponent.
Rational rational(long numerator, long denominator = 1, long exponent = 0) {
  return {numerator, denominator, exponent};
}

TEST(Rational, HoldsEveryKindOfDouble) {
  for (const double value : {0.0, 1.0, -1.5, 0x1p-1074, -0x1.8p-1073, std::numeric_limits<double>::max(), 1e-300, 0.1})
    EXPECT_EQ(round_to(binary64, exactly(value)), value);
}

TEST(Rational, RefusesWhatHasNoExactValue) {
  for (const double value : {std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity(),
                             std::numeric_limits<double>::quiet_NaN()})
    EXPECT_THROW((void)exactly(value), std::domain_error);
}

TEST(Rational, RoundsTiesToEven) {
  const Rational one = rational(1);
  EXPECT_EQ(round_to(binary64, one + exactly(0x1p-53)), 1);                             // tie, 1 is even
  EXPECT_EQ(round_to(binary64, exactly(1 + 0x1p-52) + exactly(0x1p-53)), 1 + 0x1p-51);  // tie, up to even
  EXPECT_EQ(round_to(binary64, one + exactly(0x1p-53) + exactly(0x1p-1074)), 1 + 0x1p-52);
  EXPECT_EQ(round_to(binary64, one + exactly(0x1p-53) - exactly(0x1p-1074)), 1);
}

TEST(Rational, RoundsSubnormals) {
  EXPECT_EQ(round_to(binary64, rational(1, 1, -1075)), 0);          // tie between 0 and 2^-1074
  EXPECT_EQ(round_to(binary64, rational(3, 1, -1075)), 0x1p-1073);  // tie between 1 and 2 units, even
  EXPECT_EQ(round_to(binary64, rational(5, 1, -1077)), 0x1p-1074);  // 0.625 units
  EXPECT_EQ(round_to(binary64, rational(-5, 1, -1077)), -0x1p-1074);
  EXPECT_EQ(round_to(binary64, rational(1, 3, -1074)), 0);
  EXPECT_EQ(round_to(binary64, rational(2, 3, -1074)), 0x1p-1074);
}

TEST(Rational, Overflows) {
  const Rational largest = exactly(std::numeric_limits<double>::max());
  EXPECT_EQ(round_to(binary64, largest + rational(1, 1, 969)), std::numeric_limits<double>::max());
  EXPECT_EQ(round_to(binary64, largest + rational(1, 1, 970)), infinite);  // half an ulp: ties away to 2^1024
  EXPECT_EQ(round_to(binary32, exactly(1e39)), infinite);
}

TEST(Rational, DividesAndTakesRoots) {
  EXPECT_EQ(quotient(binary64, rational(1), rational(3)), 1.0 / 3);
  EXPECT_EQ(quotient(binary64, rational(-22), rational(7, 2)), -44.0 / 7);
  EXPECT_EQ(quotient(binary64, rational(1), rational(-3)), -1.0 / 3);
  for (const double value : {2.0, 3.0, 0.1, 1e300, 1e-300, 4.0})
    EXPECT_EQ(square_root(binary64, exactly(value)), std::sqrt(value)) << value;  // IEEE sqrt rounds correctly
  EXPECT_EQ(square_root(binary64, rational(9, 4)), 1.5);
  EXPECT_EQ(square_root(binary64, rational(1, 1, -2148)), 0x1p-1074);
  EXPECT_EQ(square_root(error_format, rational(2)), 0x1.6a09e6p+0);  // sqrt 2 = 1.6a09e667f..., 24 bits
}

TEST(Rational, UlpFollowsItsDefinition) {
  const auto value = [](const Rational& x) { return round_to(binary64, ulp(x)); };
  EXPECT_EQ(value(exactly(1.0)), 0x1p-52);
  EXPECT_EQ(value(exactly(1.0) - exactly(0x1p-60)), 0x1p-53);  // just below a power of two, which no double shows
  EXPECT_EQ(value(exactly(-2.0)), 0x1p-51);
  EXPECT_EQ(value(rational(0)), 0x1p-1074);
  EXPECT_EQ(value(exactly(0x1p-1040)), 0x1p-1074);
  EXPECT_EQ(value(rational(1, 3)), 0x1p-54);
  EXPECT_EQ(value(rational(7, 3)), 0x1p-51);
}

}  // namespace

namespace {

double ulp_at(const std::vector<double>& coordinates, const Format& format) {
  const ExactPoint point = exactly(coordinates);
  const double length = Distance(point).to_origin(point.dimension);
  return ulp_of_length(point, length, format);
}

/// On one axis it is the spacing of doubles at the value.
TEST(UlpOfLength, IsTheUlpOfTheOnlyCoordinate) {
  std::mt19937_64 bits(11);
  std::vector<double> values{0.0, 1.0, 0x1p-1022, 0x1p-1074, 0x1.8p-1060, 0x1.fffffffffffffp+1023, -3.0};
  for (int k = 0; k < 2000; ++k) {
    const double power = std::ldexp(1.0, static_cast<int>(bits() % 2040) - 1020);
    for (const double value : {power, std::nextafter(power, 0.0), std::nextafter(power, 1e308), -1.3 * power})
      values.push_back(value);
  }
  for (const double value : values) {
    const double expected = round_to(binary64, ulp(exactly(value)));
    EXPECT_EQ(ulp_at({value}, binary64), expected) << value;
  }
}

/// (3, 4) 2^k has length 5 2^k; an exact power of two is reached by (2^k, 0), and just missed by less.
TEST(UlpOfLength, BelongsToTheEuclideanLength) {
  for (const int k : {-500, -3, 0, 7, 600}) {
    const double unit = std::ldexp(1.0, k);
    EXPECT_EQ(ulp_at({3 * unit, 4 * unit}, binary64), std::ldexp(1.0, k + 2 - 52));
    EXPECT_EQ(ulp_at({0.0, unit, 0.0}, binary64), std::ldexp(1.0, k - 52));
    EXPECT_EQ(ulp_at({0.0, std::nextafter(unit, 0.0)}, binary64), std::ldexp(1.0, k - 53));
    EXPECT_EQ(ulp_at({std::nextafter(unit, 0.0), unit * 0x1p-40}, binary64), std::ldexp(1.0, k - 53));  // 2^-53 short
    EXPECT_EQ(ulp_at({std::nextafter(unit, 0.0), unit * 0x1p-20}, binary64), std::ldexp(1.0, k - 52));
  }
}

TEST(UlpOfLength, FollowsTheFormat) {
  EXPECT_EQ(ulp_at({1.5}, binary32), 0x1p-23);
  EXPECT_EQ(ulp_at({0x1p-126}, binary32), 0x1p-149);
  EXPECT_EQ(ulp_at({0x1p-148}, binary32), 0x1p-149);
  EXPECT_EQ(ulp_at({0.0}, binary32), 0x1p-149);
}

TEST(ExactDistance, IsEuclidean) {
  const std::array<double, 3> a{1, 2, 3};
  const std::array<double, 3> b{1, -1, 7};
  EXPECT_EQ(distance(exactly(a), exactly(b)), 5);
  EXPECT_EQ(distance(exactly(a), exactly(a)), 0);
}

}  // namespace

}  // namespace bezierbench::reference
