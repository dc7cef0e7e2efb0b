// SPDX-License-Identifier: MIT
#include "experiments/cli/check/sections.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

namespace bezierbench::cli {
namespace {

using testing::EndsWith;
using testing::HasSubstr;
using testing::Not;

constexpr std::size_t wide = 1000;

std::vector<Section> some_sections() {
  return {{.label = "a", .head = "one", .details = {"a1", "a2", "a3", "a4"}},
          {.label = "b", .head = "two", .details = {"b1", "b2"}, .is_finding = true},
          {.label = "c", .head = "three", .details = {}}};
}

TEST(Sections, HeadsAreAlwaysShown) {
  EXPECT_EQ(text_of(some_sections(), 0, wide),
            "a           one; 4 more with --all\n"
            "b           two; 2 more with --all\n"
            "c           three\n");
}

TEST(Sections, FindingsHaveTheFirstDetail) {
  EXPECT_EQ(text_of(some_sections(), 4, wide),
            "a           one; 4 more with --all\n"
            "b           two; 1 more with --all\n"
            "            b1\n"
            "c           three\n");
}

TEST(Sections, TakeTurnsUpToTheirMost) {
  EXPECT_THAT(text_of(some_sections(), 5, wide), HasSubstr("a           one; 3 more with --all\n            a1\nb "));
  const auto all_that_is_worth_a_line = text_of(some_sections(), 100, wide);
  EXPECT_THAT(all_that_is_worth_a_line,
              HasSubstr("one; 1 more with --all\n            a1\n            a2\n            a3\nb "));
  EXPECT_THAT(all_that_is_worth_a_line, HasSubstr("two\n            b1\n            b2\nc "));
}

TEST(Sections, TheWholeTextHasEveryDetail) {
  const auto text = whole_text_of(some_sections(), wide);
  EXPECT_THAT(text, HasSubstr("a4\n"));
  EXPECT_THAT(text, Not(HasSubstr("--all")));
}

/// A detail needs as many lines as it is broken into. Where these are too many it is left out, and the next section has
/// its turn.
TEST(Sections, LinesAreCountedAsTheyAreBroken) {
  auto sections = some_sections();
  sections[1].details = {"b1 of many words that take more than one line"};
  const auto text = text_of(sections, 6, 40);
  EXPECT_LE(std::ranges::count(text, '\n'), 6);
  EXPECT_THAT(text,
              HasSubstr("b           two\n            b1 of many words that take\n            more than one line\n"));
  EXPECT_THAT(text_of(sections, 4, 40), HasSubstr("            a1\n"));
  EXPECT_THAT(text_of(sections, 4, 40), EndsWith("c           three\n"));
}

}  // namespace
}  // namespace bezierbench::cli
