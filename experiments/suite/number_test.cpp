// SPDX-License-Identifier: MIT
#include "experiments/suite/number.hpp"

#include <gtest/gtest.h>

#include <bit>
#include <clocale>
#include <cmath>
#include <cstdint>
#include <limits>
#include <locale>
#include <random>
#include <string>

namespace bezierbench::suite {
namespace {

constexpr double inf = std::numeric_limits<double>::infinity();

TEST(Number, ReadsDecimalAndHexadecimal) {
  EXPECT_EQ(parse_number("0.1"), 0.1);
  EXPECT_EQ(parse_number("-1e-3"), -1e-3);
  EXPECT_EQ(parse_number("+7"), 7.0);
  EXPECT_EQ(parse_number("0x1.8p-1"), 0.75);
  EXPECT_EQ(parse_number("-0X1P4"), -16.0);
  EXPECT_EQ(parse_number("+0x.8"), 0.5);
  EXPECT_EQ(parse_number("0x1p-1074"), std::numeric_limits<double>::denorm_min());
  EXPECT_EQ(parse_number("1e-320"), 1e-320);
  EXPECT_EQ(parse_number("inf"), inf);
  EXPECT_EQ(parse_number("-inf"), -inf);
  EXPECT_TRUE(std::isnan(parse_number("nan").value_or(0)));
  EXPECT_TRUE(std::signbit(parse_number("-0").value_or(1)));
}

TEST(Number, RefusesWhatIsNotAllANumber) {
  for (const char* text : {"", "-", "+", "0x", "1 ", " 1", "1,5", "1e", "1x", "--1", "+-1", "-+1", "0x-1", "0xinf",
                           "nan(1)", "0x1p", "1e999", "1_000", "0x0x1"}) {
    EXPECT_FALSE(parse_number(text)) << text;
  }
}

TEST(Number, ShortestReadsBackToTheSameBits) {
  EXPECT_EQ(shortest(0.1), "0.1");
  EXPECT_EQ(shortest(1e6), "1e+06");
  EXPECT_EQ(shortest(1000), "1000");
  EXPECT_EQ(shortest(-0.0), "-0");
  EXPECT_EQ(shortest(-inf), "-inf");
  EXPECT_EQ(shortest(-std::numeric_limits<double>::quiet_NaN()), "nan");
  std::mt19937_64 random(1);
  for (int i = 0; i < 20000; ++i) {
    const auto x = std::bit_cast<double>(random());
    if (!std::isfinite(x)) continue;
    const auto back = parse_number(shortest(x));
    ASSERT_TRUE(back) << shortest(x);
    ASSERT_EQ(std::bit_cast<std::uint64_t>(*back), std::bit_cast<std::uint64_t>(x)) << shortest(x);
  }
}

TEST(Number, IntegersMayBeWrittenAsFloatingPoint) {
  EXPECT_EQ(parse_integer("42"), 42);
  EXPECT_EQ(parse_integer("9223372036854775807"), std::numeric_limits<std::int64_t>::max());
  EXPECT_EQ(parse_integer("1e4"), 10000);
  EXPECT_EQ(parse_integer("0x1p3"), 8);
  EXPECT_FALSE(parse_integer("4.5"));
  EXPECT_FALSE(parse_integer("9223372036854775808"));
  EXPECT_FALSE(parse_integer("inf"));
  EXPECT_FALSE(parse_integer("nan"));
  EXPECT_FALSE(parse_integer("four"));
}

/// A decimal comma and grouped digits.
struct Comma : std::numpunct<char> {
  char do_decimal_point() const override { return ','; }
  char do_thousands_sep() const override { return '.'; }
  std::string do_grouping() const override { return "\3"; }
};

TEST(Number, NoLocaleChangesAByte) {
  const std::locale before = std::locale::global(std::locale(std::locale::classic(), new Comma));
  const char* german = std::setlocale(LC_NUMERIC, "de_DE.UTF-8");  // where there is one
  EXPECT_EQ(shortest(0.5), "0.5");
  EXPECT_EQ(shortest(123456), "123456");
  EXPECT_EQ(parse_number("0.5"), 0.5);
  EXPECT_FALSE(parse_number("0,5"));
  if (german != nullptr) std::setlocale(LC_NUMERIC, "C");
  std::locale::global(before);
}

}  // namespace
}  // namespace bezierbench::suite
