// SPDX-License-Identifier: MIT
#include "experiments/metric/error_units.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace bezierbench::metric {
namespace {

TEST(ErrorUnits, AreQuotientsTo24Bits) {
  ErrorLanes errors{0, 0, 1, 3, 0x1p-1074, 1, std::nextafter(1.0, 2.0)};
  ErrorLanes divisors{0, 5, 0, 2, 4, 3, 1};
  errors[15] = 7;
  divisors[15] = 0x1p+10;
  const auto units = in_units(errors, divisors);
  EXPECT_EQ(units[0], 0);
  EXPECT_EQ(units[1], 0);
  EXPECT_EQ(units[2], std::numeric_limits<double>::infinity());
  EXPECT_EQ(units[3], 1.5);
  EXPECT_EQ(units[4], 0);
  EXPECT_EQ(units[5], static_cast<double>(1.0F / 3.0F));
  EXPECT_EQ(units[6], 1);
  EXPECT_EQ(units[15], 0x7p-10);
  EXPECT_EQ(in_units(errors, divisors, 0x1p-53)[3], 0x3p+52);
}

}  // namespace
}  // namespace bezierbench::metric
