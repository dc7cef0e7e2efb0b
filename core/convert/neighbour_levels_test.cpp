// SPDX-License-Identifier: MIT
// Several levels in one pass are the levels one by one.
#include "core/convert/neighbour_levels.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace bezierbench {
namespace {

/// Texts show the operands and the order of every step.
TEST(NeighbourLevels, AreThoseOfTheDefinition) {
  const auto combine = [](const std::string& here, const std::string& before) { return "(" + here + before + ")"; };
  for (int n = 0; n <= 9; ++n) {
    std::vector<std::string> expected;
    for (int i = 0; i <= n; ++i) expected.push_back(std::to_string(i));
    auto found = expected;
    const auto at = [&](int i) -> std::string& { return found[static_cast<std::size_t>(i)]; };
    combine_neighbours(at, n, combine);
    for (std::size_t k = 1; k < expected.size(); ++k)
      for (std::size_t i = expected.size() - 1; i >= k; --i) expected[i] = combine(expected[i], expected[i - 1]);
    EXPECT_EQ(found, expected) << n;
  }
}

}  // namespace
}  // namespace bezierbench
