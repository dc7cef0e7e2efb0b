// SPDX-License-Identifier: MIT
#include "experiments/timing/sentinel.hpp"

#include <gtest/gtest.h>

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

}  // namespace
}  // namespace bezierbench::timing
