// SPDX-License-Identifier: MIT
#include "reference/exact_point.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <random>
#include <vector>

namespace bezierbench::reference {
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
