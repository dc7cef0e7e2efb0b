// SPDX-License-Identifier: MIT
#include "experiments/race/counters.hpp"

#include <gtest/gtest.h>

namespace bezierbench::race {
namespace {

TEST(Counters, CountsAreScaledToTheWholeTime) {
  const CounterReading before{2, 100, 100, 1000, 5000};
  const auto all = counts_between(before, {2, 300, 300, 1800, 7000});
  ASSERT_TRUE(all);
  EXPECT_EQ(all->cycles, 800);
  EXPECT_EQ(all->instructions, 2000);
  const auto half = counts_between(before, {2, 300, 200, 1800, 7000});  // counted half of the time
  ASSERT_TRUE(half);
  EXPECT_EQ(half->cycles, 1600);
  EXPECT_EQ(half->instructions, 4000);
}

TEST(Counters, WhatNeverRanIsUnknown) {
  const CounterReading before{2, 100, 100, 1000, 5000};
  EXPECT_FALSE(counts_between(before, {2, 300, 100, 1000, 5000}));
  EXPECT_FALSE(counts_between(before, before));
}

/// Either they count, more for more work, or they say why not.
TEST(Counters, CountOrSayWhyNot) {
  const Counters counters;
  if (!counters.available()) {
    EXPECT_EQ(counters.state().rfind("unavailable: ", 0), 0U);
    EXPECT_GT(counters.state().size(), std::string("unavailable: ").size());
    EXPECT_FALSE(counters.read());
    return;
  }
  const auto instructions_of = [&](int steps) {
    const auto before = counters.read();
    volatile int sum = 0;
    for (int k = 0; k < steps; ++k) sum = sum + k;
    return counts_between(*before, *counters.read())->instructions;
  };
  EXPECT_GE(instructions_of(100000), 100000);
  EXPECT_LT(instructions_of(1000), 100000);
}

}  // namespace
}  // namespace bezierbench::race
