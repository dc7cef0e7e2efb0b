// SPDX-License-Identifier: MIT

#include "experiments/cli/terminal/text.hpp"

#include <gtest/gtest.h>

namespace bezierbench::cli {
namespace {

const std::vector<std::vector<std::string>> table{
    {"id", "n", "title"}, {"a", "10", "one two three four five six seven eight nine ten"}, {"bcd", "2", ""}};

TEST(Fitted, OneLinePerRowWithoutATerminal) {
  EXPECT_EQ(fitted(table, std::nullopt),
            "id   n   title\n"
            "a    10  one two three four five six seven eight nine ten\n"
            "bcd  2\n");
  EXPECT_EQ(fitted(table, 200), fitted(table, std::nullopt));
}

TEST(Fitted, TheLastColumnIsBroken) {
  EXPECT_EQ(fitted(table, 40),
            "id   n   title\n"
            "a    10  one two three four five six\n"
            "         seven eight nine ten\n"
            "bcd  2\n");
}

TEST(Fitted, WhereItWouldBeNarrowItGoesBelow) {
  EXPECT_EQ(fitted(table, 30),
            "id   n\n"
            "a    10\n"
            "    one two three four five\n"
            "    six seven eight nine ten\n"
            "bcd  2\n");
}

TEST(Fitted, SeveralFieldsBelowHaveNames) {
  EXPECT_EQ(fitted({{"id", "a long name", "b"}, {"x", "", "c"}, {"y", "1", "2"}}, 12),
            "id\nx\n    b c\ny\n    a long\n    name 1;\n    b 2\n");
}

TEST(Fitted, NothingActsOnTheTerminal) { EXPECT_EQ(fitted({{"id"}, {"\x1b[2J"}}, std::nullopt), "id\n\\x1b[2J\n"); }

TEST(Fitted, NoWidthIsTooSmall) {
  for (std::size_t width = 1; width < 60; ++width) EXPECT_NE(fitted(table, width).find("eight"), std::string::npos);
}

TEST(Wrapped, CountsCharactersNotBytes) {
  EXPECT_EQ(length_of("gr\xc3\xb6\xc3\x9f"
                      "e"),
            5U);
  EXPECT_EQ(wrapped("", "\xc3\xb6\xc3\xb6 \xc3\xb6\xc3\xb6", 0, 5), "\xc3\xb6\xc3\xb6 \xc3\xb6\xc3\xb6\n");
  EXPECT_EQ(wrapped("head: ", "a bb ccc", 2, 10), "head: a bb\n  ccc\n");
  EXPECT_EQ(wrapped("", "a  bbbb", 2, 4), "a\n  bbbb\n");  // no blank at the end of a line
}

TEST(ShellWord, CanBePasted) {
  EXPECT_EQ(shell_word("a/b-c_1.csv"), "a/b-c_1.csv");
  EXPECT_EQ(shell_word(""), "''");
  EXPECT_EQ(shell_word("it's $x"), "'it'\\''s $x'");
}

}  // namespace
}  // namespace bezierbench::cli
