// SPDX-License-Identifier: MIT
#include "experiments/suite/nearest.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace bezierbench::suite {
namespace {

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
