// SPDX-License-Identifier: MIT
#include "experiments/sample/knot_kind.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace bezierbench::sample {
namespace {

std::vector<double> drawn(std::string_view id, int degree, std::uint64_t trial) {
  Words words(1, 2, 3, trial);
  return draw_knots(*std::ranges::find(knot_kinds(), id, &KnotKind::id), degree, words);
}

/// The number of knots that are equal to the one at `place`.
std::ptrdiff_t multiplicity(const std::vector<double>& knots, std::size_t place) {
  return std::ranges::count(knots, knots[place]);
}

TEST(KnotKinds, AscendAndLeaveASpan) {
  for (const auto& kind : knot_kinds())
    for (const int degree : {1, 2, 5, 20, 200})
      for (std::uint64_t trial = 0; trial < 50; ++trial) {
        const auto knots = drawn(kind.id, degree, trial);
        ASSERT_EQ(knots.size(), 2 * static_cast<std::size_t>(degree)) << kind.id;
        EXPECT_TRUE(std::ranges::is_sorted(knots)) << kind.id;
        EXPECT_LT(knots[knots.size() / 2 - 1], knots[knots.size() / 2]) << kind.id;
      }
}

TEST(KnotKinds, AreWhatTheirNamesSay) {
  int threefold = 0;
  double widest = 0;
  double narrowest = 1;
  for (std::uint64_t trial = 0; trial < 100; ++trial) {
    const auto uniform = drawn("uniform", 3, trial);
    EXPECT_EQ(uniform[2], std::floor(uniform[2]));
    for (std::size_t k = 1; k < uniform.size(); ++k) EXPECT_EQ(uniform[k] - uniform[k - 1], 1);
    const auto clamped = drawn("clamped", 3, trial);
    EXPECT_EQ(multiplicity(clamped, 0), 3);
    EXPECT_EQ(multiplicity(clamped, 3), 1);
    EXPECT_EQ(multiplicity(drawn("random", 3, trial), 2), 1);
    if (multiplicity(drawn("multiple", 3, trial), 3) == 3) ++threefold;
    const auto uneven = drawn("uneven", 3, trial);
    for (std::size_t k = 1; k < uneven.size(); ++k) {
      widest = std::max(widest, uneven[k] - uneven[k - 1]);
      narrowest = std::min(narrowest, uneven[k] - uneven[k - 1]);
    }
  }
  EXPECT_GT(threefold, 10) << "a quarter of the cases";
  EXPECT_LT(threefold, 50);
  EXPECT_GT(widest, 0.25);
  EXPECT_LT(narrowest, 0x1p-38);
}

}  // namespace
}  // namespace bezierbench::sample
