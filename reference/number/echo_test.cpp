// SPDX-License-Identifier: MIT
#include "reference/number/echo.hpp"

#include <gtest/gtest.h>

namespace bezierbench {
namespace {

TEST(Echo, TextStays) {
  for (const char* text : {"", "a b/c.csv", "\"1,2\" \\n",
                           "gr\xc3\xb6\xc3\x9f"
                           "e",
                           "\xe6\x9b\xb2", "\xf0\x9f\x98\x80"})
    EXPECT_EQ(printable(text), text);
}

TEST(Echo, WhatActsOnATerminalIsEscaped) {
  EXPECT_EQ(printable("\x1b[2J"), "\\x1b[2J");
  EXPECT_EQ(printable("a\r\n\tb\x7f"), "a\\x0d\\x0a\\x09b\\x7f");
  EXPECT_EQ(printable(std::string_view("\0", 1)), "\\x00");
}

TEST(Echo, LongTextLosesItsMiddle) {
  const std::string long_text = "begin" + std::string(5'000'000, 'x') + "end";
  const auto shown = echo(long_text);
  EXPECT_LT(shown.size(), 120U);
  EXPECT_TRUE(shown.starts_with("begin")) << shown;
  EXPECT_TRUE(shown.ends_with("end")) << shown;
  EXPECT_EQ(shortened("1234567890", 10), "1234567890");
  EXPECT_EQ(shortened("1234567890a", 9), "123456 ... 2 bytes ... 90a");
}

// The bytes of a character of UTF-8 are not separated.
TEST(Echo, CharactersAreNotCut) {
  std::string text;
  for (int k = 0; k < 1000; ++k) text += "\xe6\x9b\xb2";
  for (std::size_t most = 3; most < 40; ++most) EXPECT_EQ(shortened(text, most).find(" ... ") % 3, 0U) << most;
}

}  // namespace
}  // namespace bezierbench
