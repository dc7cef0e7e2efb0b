// SPDX-License-Identifier: MIT
#include "experiments/timing/sentinel.hpp"

#include <gtest/gtest.h>

#include <vector>

namespace bezierbench::timing {
namespace {

TEST(Sentinel, KnowsItsResult) {
  const Rival rival = sentinel();
  EXPECT_EQ(rival.name, "sentinel");
  EXPECT_FALSE(rival.check()) << "nothing ran yet";
  rival.run();
  EXPECT_TRUE(rival.check());
  EXPECT_FALSE(rival.check()) << "a check uses the result up";
}

TEST(Sentinel, HalvesAreCompared) {
  const auto slower_at_the_end = half_medians(std::vector<double>{1, 9, 1, 1, 2, 2, 2, 1});
  EXPECT_EQ(slower_at_the_end.fast, 1);
  EXPECT_EQ(slower_at_the_end.slow, 2);
  const auto slower_at_the_start = half_medians(std::vector<double>{3, 3, 1, 1, 1});
  EXPECT_EQ(slower_at_the_start.fast, 1);
  EXPECT_EQ(slower_at_the_start.slow, 3);
  EXPECT_EQ(half_medians(std::vector<double>{5}).slow, 5);
}

TEST(Sentinel, DriftIsAgainstTheFastestOfAll) {
  EXPECT_EQ(drift({1, 1}, 1), 0);
  EXPECT_EQ(drift({1, 1.5}, 1), 0.5);
  EXPECT_EQ(drift({2, 2}, 1), 1) << "steady, but slower than an earlier race";
}

}  // namespace
}  // namespace bezierbench::timing
