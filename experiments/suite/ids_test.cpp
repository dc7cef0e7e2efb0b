// SPDX-License-Identifier: MIT
#include "experiments/suite/ids.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace bezierbench::suite {
namespace {

TEST(Pattern, LiteralTextIsMatchedWhole) {
  EXPECT_TRUE(matches("horner", "horner"));
  EXPECT_FALSE(matches("horner", "horner_fma"));
  EXPECT_FALSE(matches("horner_fma", "horner"));
  EXPECT_TRUE(matches("", ""));
  EXPECT_FALSE(matches("", "a"));
}

TEST(Pattern, StarTakesAnyRun) {
  EXPECT_TRUE(matches("*", ""));
  EXPECT_TRUE(matches("horner*", "horner"));
  EXPECT_TRUE(matches("*:horner*", "exact:horner_fma"));
  EXPECT_FALSE(matches("*:horner", "exact:horner_fma"));
  EXPECT_TRUE(matches("*a*b", "aabab"));  // needs a later place for the first star
  EXPECT_FALSE(matches("a*b*c", "acb"));
}

TEST(Pattern, QuestionMarkTakesExactlyOne) {
  EXPECT_TRUE(matches("2.?", "2.2"));
  EXPECT_FALSE(matches("2.?", "2."));
  EXPECT_FALSE(matches("2.?", "2.22"));
  EXPECT_TRUE(matches("*?", "a"));
  EXPECT_FALSE(matches("*?", ""));
}

TEST(Pattern, ManyStarsStayFast) {
  std::string pattern;
  for (int i = 0; i < 40; ++i) pattern += "a*";
  EXPECT_FALSE(matches(pattern + "b", std::string(4000, 'a')));
}

TEST(Pattern, MeansPeersOnlyWhereItSaysSo) {
  EXPECT_TRUE(means("de_*", "de_casteljau"));
  EXPECT_TRUE(means("peer_gsl", "peer_gsl"));
  EXPECT_TRUE(means("peer_*", "peer_gsl"));
  EXPECT_FALSE(means("peer_*", "de_casteljau"));
  for (const auto* pattern : {"*", "p*", "*gsl", "peer*", "?eer_gsl"})
    EXPECT_FALSE(means(pattern, "peer_gsl")) << pattern;
}

TEST(Pattern, KnowsAPatternFromAnId) {
  EXPECT_TRUE(is_pattern("a*"));
  EXPECT_TRUE(is_pattern("?"));
  EXPECT_FALSE(is_pattern("factorial+forward_substitution:direct.1-2"));
}

const std::vector<std::string> ids{"direct", "direct_pow", "de_casteljau", "horner", "exact"};

TEST(Nearest, FindsTheWordThatWasMeant) {
  EXPECT_EQ(nearest("de_castlejau", ids), "de_casteljau");
  EXPECT_EQ(nearest("hroner", ids), "horner");
  EXPECT_EQ(nearest("direct_po", ids), "direct_pow");
  EXPECT_EQ(nearest("exact", ids), "exact");
}

TEST(Nearest, StaysSilentWhenNothingIsClose) {
  EXPECT_EQ(nearest("wang_ball", ids), "");
  EXPECT_EQ(nearest("", ids), "");
  EXPECT_EQ(nearest("x", std::vector<std::string>{"y"}), "");
  EXPECT_EQ(nearest("x", {}), "");
}

TEST(Nearest, ASwapOfNeighboursIsOneStep) { EXPECT_EQ(nearest("ba", std::vector<std::string>{"abc", "ab"}), "ab"); }

TEST(Nearest, SuggestionListsWhatIsKnownWhenNothingIsClose) {
  EXPECT_EQ(suggestion("hroner", ids), "; did you mean \"horner\"?");
  EXPECT_EQ(suggestion("wang_ball", ids), "; known are direct, direct_pow, de_casteljau, horner, exact");
}

}  // namespace
}  // namespace bezierbench::suite
