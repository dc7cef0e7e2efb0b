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
  EXPECT_EQ(printable("\xc2\x9b"
                      "31m"),
            "\\xc2\\x9b31m");                               // the control sequence introducer in one character
  EXPECT_EQ(printable("\xe2\x80\xae"), "\\xe2\\x80\\xae");  // right-to-left override
  EXPECT_EQ(printable("\xe2\x80\xa8\xe2\x81\xa6"), "\\xe2\\x80\\xa8\\xe2\\x81\\xa6");
}

// A single byte from 0x80 to 0x9f is a control character on a terminal that does not read UTF-8.
TEST(Echo, WhatIsNoUtf8IsEscaped) {
  EXPECT_EQ(printable("\x9b"
                      "31m"),
            "\\x9b31m");
  EXPECT_EQ(printable("\xc3"), "\\xc3");           // cut short
  EXPECT_EQ(printable("\xc0\xaf"), "\\xc0\\xaf");  // an overlong encoding
  EXPECT_EQ(printable("\xe0\x80\x9b"), "\\xe0\\x80\\x9b");
  EXPECT_EQ(printable("\xed\xa0\x80"), "\\xed\\xa0\\x80");                    // half of a surrogate pair
  EXPECT_EQ(printable("\xf4\x90\x80\x80\xff"), "\\xf4\\x90\\x80\\x80\\xff");  // beyond the last code point
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

// The bytes of a character are not separated: half a character would be escaped.
TEST(Echo, CharactersAreNotCut) {
  std::string text;
  for (int k = 0; k < 1000; ++k) text += "\xe6\x9b\xb2";
  for (std::size_t most = 3; most < 40; ++most) EXPECT_EQ(shortened(text, most).find('\\'), std::string::npos) << most;
}

}  // namespace
}  // namespace bezierbench
