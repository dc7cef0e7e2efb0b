// SPDX-License-Identifier: MIT
// The functions of libm have the same bits.
#include "core/powers.hpp"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <cstdint>
#include <vector>

namespace bezierbench {
namespace {

std::vector<double> numbers() {
  std::vector<double> all{1,
                          -1,
                          1.5,
                          0x1.fffffffffffffp+0,
                          0x1.fffffffffffffp+1023,
                          0x1p-1022,
                          0x1.fffffffffffffp-1023,
                          0x1p-1074,
                          -0x1.8p-1073,
                          0x1.0000000000001p-1000};
  for (int e = -1074; e <= 1023; e += 61) all.push_back(std::ldexp(1.0 + 0x1.3p-7, e));
  return all;
}

TEST(BinaryExponent, TimesItIsLdexp) {
  for (const double value : numbers())
    for (int e = -2200; e <= 2200; ++e) {
      const auto bits = std::bit_cast<std::uint64_t>(times_power_of_two(value, e));
      ASSERT_EQ(bits, std::bit_cast<std::uint64_t>(std::ldexp(value, e))) << value << " " << e;
    }
  EXPECT_EQ(times_power_of_two(0, 5), 0);
}

TEST(BinaryExponent, ExponentIsThatOfFrexp) {
  for (const double value : numbers()) {
    int exponent = 0;
    std::frexp(value, &exponent);
    EXPECT_EQ(binary_exponent(value), exponent) << value;
  }
}

}  // namespace
}  // namespace bezierbench
