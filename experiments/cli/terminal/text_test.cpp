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
  EXPECT_EQ(fitted(table, 24),
            "id   n\n"
            "a    10\n"
            "    one two three four\n"
            "    five six seven eight\n"
            "    nine ten\n"
            "bcd  2\n");
}

TEST(Fitted, WideColumnsAreBrokenFirst) {
  EXPECT_EQ(fitted({{"id", "bound", "cost"}, {"a", "some words that are a bound", "words and a number"}}, 42),
            "id  bound               cost\n"
            "a   some words that     words and a number\n"
            "    are a bound\n");
}

TEST(Fitted, ALongIdHasALineOfItsOwn) {
  EXPECT_EQ(fitted({{"id", "n"}, {"an_id_that_is_longer_than_others", "1"}, {"b", "2"}}, 32),
            "id                             n\n"
            "an_id_that_is_longer_than_others\n"
            "                               1\n"
            "b                              2\n");
}

TEST(Fitted, OptionalColumnsAreLeftOut) {
  EXPECT_EQ(fitted({{"id", "n", "m"}, {"a", "1", "2"}}, 8, 2), "id  n  m\na   1  2\n");
  EXPECT_EQ(fitted({{"id", "n", "m"}, {"a", "1", "2"}}, 5, 1), "id  n\na   1\n");
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
  EXPECT_EQ(wrapped("", "do `a b c` now", 2, 6), "do\n  `a b c`\n  now\n");  // a command can be pasted
  EXPECT_EQ(wrapped("", "a  bbbb", 2, 4), "a\n  bbbb\n");                    // no blank at the end of a line
}

TEST(ShellWord, CanBePasted) {
  EXPECT_EQ(shell_word("a/b-c_1.csv"), "a/b-c_1.csv");
  EXPECT_EQ(shell_word(""), "''");
  EXPECT_EQ(shell_word("it's $x"), "'it'\\''s $x'");
}

}  // namespace
}  // namespace bezierbench::cli
