// SPDX-License-Identifier: MIT
#include "experiments/race/sentinel.hpp"

#include <gtest/gtest.h>

namespace bezierbench::race {
namespace {

TEST(Sentinels, KnowTheirResults) {
  for (const Rival& rival : sentinels()) {
    EXPECT_FALSE(rival.check()) << "nothing ran yet";
    rival.run();
    EXPECT_TRUE(rival.check());
    EXPECT_FALSE(rival.check()) << "a check uses the result up";
  }
  EXPECT_EQ(sentinels().back().name, sentinel_name);
}

}  // namespace
}  // namespace bezierbench::race
