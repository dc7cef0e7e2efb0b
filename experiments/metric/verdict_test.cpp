// SPDX-License-Identifier: MIT
#include "experiments/metric/verdict.hpp"

#include <gtest/gtest.h>

#include <limits>

namespace bezierbench::metric {
namespace {

TEST(Verdict, FollowsTheInterval) {
  EXPECT_EQ(verdict({1, 0.99, 1.01}), Verdict::same);
  EXPECT_EQ(verdict({1, 0.9899, 1.01}), Verdict::unresolved);
  EXPECT_EQ(verdict({1, 0.99, 1.0101}), Verdict::unresolved);
  EXPECT_EQ(verdict({1.02, 1.01, 1.03}), Verdict::unresolved);
  EXPECT_EQ(verdict({1.02, 1.0101, 1.03}), Verdict::slower);
  EXPECT_EQ(verdict({0.98, 0.97, 0.99}), Verdict::unresolved);
  EXPECT_EQ(verdict({0.98, 0.97, 0.9899}), Verdict::faster);
  EXPECT_EQ(verdict({1, 0.5, 2}), Verdict::unresolved);
  EXPECT_EQ(verdict({1.2, 1.1, 1.3}, 0.5), Verdict::same);
}

TEST(Verdict, NotANumberIsUnresolved) {
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(verdict({nan, nan, nan}), Verdict::unresolved);
  EXPECT_EQ(verdict({1, nan, 1}), Verdict::unresolved);
  EXPECT_EQ(verdict({1, 1, nan}), Verdict::unresolved);
}

}  // namespace
}  // namespace bezierbench::metric
