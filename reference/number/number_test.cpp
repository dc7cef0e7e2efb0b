// SPDX-License-Identifier: MIT
#include "reference/number/number.hpp"

#include <gtest/gtest.h>

#include <bit>
#include <clocale>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <limits>
#include <locale>
#include <random>
#include <string>
#include <vector>

namespace bezierbench::number {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

std::uint64_t bits(double value) { return std::bit_cast<std::uint64_t>(value); }

// Bit patterns from the whole range of doubles, and the awkward ones by name.
std::vector<double> doubles() {
  std::vector<double> values{0.0,
                             -0.0,
                             1.0,
                             -1.0,
                             3.0,
                             0.1,
                             0x1p-1074,
                             0x1p-1022,
                             0x1.fffffffffffffp+1023,
                             0x0.fffffffffffffp-1022,
                             0x1.8p+1,
                             0x1.00000000000ap-3,
                             1e22,
                             1e23,
                             -123456.0};
  std::mt19937_64 words(1);
  while (values.size() < 20000) {
    std::uint64_t word = words();
    if (values.size() % 4 == 0) word &= 0x800fffffffffffff;                        // subnormal
    if (values.size() % 3 == 0) word &= ~((std::uint64_t{1} << (word % 53)) - 1);  // trailing zeros
    if (const auto value = std::bit_cast<double>(word); std::isfinite(value)) values.push_back(value);
  }
  return values;
}

TEST(Number, DecimalIsShortest) {
  EXPECT_EQ(decimal(0.1), "0.1");
  EXPECT_EQ(decimal(-0.0), "-0");
  EXPECT_EQ(decimal(1e300), "1e+300");
  EXPECT_EQ(decimal(0x1p-1074), "5e-324");
  EXPECT_EQ(decimal(-2.2250738585072014e-308), "-2.2250738585072014e-308");
}

TEST(Number, NonFinite) {
  const double negative_nan = -std::numeric_limits<double>::quiet_NaN();
  for (auto* write : {decimal, hexadecimal}) {
    EXPECT_EQ(write(infinity), "inf");
    EXPECT_EQ(write(-infinity), "-inf");
    EXPECT_EQ(write(std::numeric_limits<double>::quiet_NaN()), "nan");
    EXPECT_EQ(write(negative_nan), "nan");
  }
  EXPECT_EQ(parse_number("inf"), infinity);
  EXPECT_EQ(parse_number("+inf"), infinity);
  EXPECT_EQ(parse_number("-inf"), -infinity);
  ASSERT_TRUE(parse_number("nan"));
  EXPECT_TRUE(std::isnan(*parse_number("nan")));
}

TEST(Number, HexadecimalIsPrintfs) {
  EXPECT_EQ(hexadecimal(3.0), "0x1.8p+1");
  EXPECT_EQ(hexadecimal(-0.0), "-0x0p+0");
  EXPECT_EQ(hexadecimal(0x1p-1074), "0x0.0000000000001p-1022");
  for (const double value : doubles()) {
    char expected[40];
    std::snprintf(expected, sizeof expected, "%a", value);
    ASSERT_EQ(hexadecimal(value), expected);
  }
}

TEST(Number, BothReadBackToTheSameBits) {
  for (const double value : doubles()) {
    const auto from_decimal = parse_number(decimal(value));
    const auto from_hexadecimal = parse_number(hexadecimal(value));
    ASSERT_TRUE(from_decimal && from_hexadecimal) << decimal(value);
    ASSERT_EQ(bits(*from_decimal), bits(value)) << decimal(value);
    ASSERT_EQ(bits(*from_hexadecimal), bits(value)) << hexadecimal(value);
  }
}

TEST(Number, ReadsWhatPeopleWrite) {
  EXPECT_EQ(parse_number("+0.5"), 0.5);
  EXPECT_EQ(parse_number(".5"), 0.5);
  EXPECT_EQ(parse_number("5."), 5.0);
  EXPECT_EQ(parse_number("1E3"), 1000.0);
  EXPECT_EQ(parse_number("0X1.8P+1"), 3.0);
  EXPECT_EQ(parse_number("-0x.8p1"), -1.0);
  EXPECT_EQ(parse_number("0x10"), 16.0);
  EXPECT_EQ(bits(parse_number("-0").value()), bits(-0.0));
}

TEST(Number, LongHexadecimalRoundsToNearestEven) {
  EXPECT_EQ(parse_number("0x1.00000000000008p+0"), 1.0);
  EXPECT_EQ(parse_number("0x1.000000000000080000000000000001p+0"), 0x1.0000000000001p+0);
  EXPECT_EQ(parse_number("0x1.00000000000018p+0"), 0x1.0000000000002p+0);
  EXPECT_EQ(parse_number("0x0.00000000000018p-1022"), 0x0.0000000000002p-1022);
  std::mt19937_64 words(2);
  for (int i = 0; i < 5000; ++i) {
    char text[64];
    std::snprintf(text, sizeof text, "0x%llx.%llxp%d", static_cast<unsigned long long>(words()),
                  static_cast<unsigned long long>(words()), static_cast<int>(words() % 2140) - 1140);
    const double expected = std::strtod(text, nullptr);
    if (expected == 0 || std::isinf(expected)) continue;
    ASSERT_EQ(parse_number(text), expected) << text;
  }
}

TEST(Number, RefusesEverythingElse) {
  for (const char* text : {"",          " ",     "1 ",    " 1",     "+",      "-",  "+-1", "--1",   "-+1",
                           "1,5",       "1e",    "1e400", "-1e400", "1e-400", "0x", "-0x", "0x1p",  "0x1p+5000",
                           "0x1p-5000", "0x.p1", "0xg",   "0x-1",   "0x0x1",  ".",  "-.",  "e5",    "infinity",
                           "INF",       "-nan",  "+nan",  "nan(1)", "NaN",    "1f", "0b1", "1_000", "1\n"}) {
    EXPECT_EQ(parse_number(text), std::nullopt) << '"' << text << '"';
  }
  EXPECT_EQ(parse_number(std::string_view("1\0", 2)), std::nullopt);
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
  EXPECT_EQ(decimal(0.5), "0.5");
  EXPECT_EQ(decimal(123456), "123456");
  EXPECT_EQ(parse_number("0.5"), 0.5);
  EXPECT_FALSE(parse_number("0,5"));
  if (german != nullptr) std::setlocale(LC_NUMERIC, "C");
  std::locale::global(before);
}

TEST(NumberFault, SaysWhetherANumberIsTooSmallOrTooLarge) {
  for (const auto* text : {"1e-400", "-1E-400", "+.5e-400", "0x1p-2000", "0x.8p-99999999999999999999"})
    EXPECT_TRUE(fault(text).starts_with("is too small for a double;")) << text;
  for (const auto* text : {"1e400", "-1e+400", "0.1e999", "0x1p+2000", "1e99999999999999999999"})
    EXPECT_TRUE(fault(text).starts_with("is too large for a double;")) << text;
  EXPECT_TRUE(fault("0." + std::string(400, '0') + "1").starts_with("is too small"));
  EXPECT_TRUE(fault(std::string(400, '9')).starts_with("is too large"));
}

TEST(NumberFault, SaysWhatElseIsWrong) {
  for (const auto* text : {"(1", "2)", "[1]"}) EXPECT_NE(fault(text).find("without brackets"), std::string_view::npos);
  for (const auto* text : {"", "x", "nan", "-inf", "1e400x", "0x", "1 2"})
    EXPECT_TRUE(fault(text).starts_with("is not a finite number;")) << text;
}

}  // namespace

}  // namespace bezierbench::number
