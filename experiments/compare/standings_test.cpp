// SPDX-License-Identifier: MIT
#include "experiments/compare/standings.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "experiments/compare/side_test.hpp"

namespace bezierbench::compare {
namespace {

std::vector<Comparison> compared(const Side& a, const std::vector<Side>& others) {
  std::vector<Comparison> comparisons;
  for (const auto& other : others) comparisons.push_back(compare_sides(a, other));
  rank(comparisons);
  return comparisons;
}

/// The ranks of every row of every comparison, in a and in b.
std::vector<int> ranks(const Side& a, const std::vector<Side>& others) {
  std::vector<int> found;
  for (const auto& comparison : compared(a, others))
    for (const auto& row : comparison.times) found.insert(found.end(), {row.timed->rank_a, row.timed->rank_b});
  return found;
}

// A rank counts the methods that are certainly faster: neighbours with overlapping intervals share a rank.
TEST(Ranks, AreOfTheCertainlyFaster) {
  const auto a =
      timed("a", timing_row("x", 10) + timing_row("y", 20) + timing_row("z", 20.01) + timing_row("sentinel", 1));
  const auto b =
      timed("b", timing_row("x", 30) + timing_row("y", 20) + timing_row("z", 25) + timing_row("sentinel", 1));
  EXPECT_EQ(ranks(a, {b}), (std::vector<int>{1, 3, 2, 1, 2, 2, 0, 0}));
}

// c has no y, so neither pair ranks y, and x has the same rank in a whichever bundle a is compared with.
TEST(Ranks, OfSeveralBundlesAreAmongWhatAllHave) {
  const auto rows = timing_row("x", 20) + timing_row("y", 10) + timing_row("z", 15);
  const std::vector<Side> others{timed("b", rows), timed("c", timing_row("x", 20) + timing_row("z", 15))};
  EXPECT_EQ(ranks(timed("a", rows), others), (std::vector<int>{2, 2, 0, 0, 1, 1, 2, 2, 1, 1}));
}

/// The methods that changed their place.
std::string changed(const std::string& a, const std::string& b) {
  const auto side_a = timed("a", a);
  const std::vector<Side> others{timed("b", b)};
  const auto comparisons = compared(side_a, others);
  std::string methods;
  for (const auto& row : comparisons.front().times)
    if (row.timed->changed_place) methods += row.inputs.field("method");
  return methods;
}

TEST(Ranks, PlacesChangeOnlyWhereBothSidesResolveTheRatio) {
  const std::string ahead = timing_row("x", 10) + timing_row("y", 12);
  EXPECT_EQ(changed(ahead, timing_row("x", 12) + timing_row("y", 10)), "xy");
  EXPECT_EQ(changed(ahead, timing_row("x", 20) + timing_row("y", 30)), "");
  EXPECT_EQ(changed(ahead, timing_row("x", 12, {.spread = 0.2}) + timing_row("y", 10, {.spread = 0.2})), "")
      << "the second side cannot tell";
  EXPECT_EQ(changed(ahead, timing_row("x", 10.05) + timing_row("y", 10)), "") << "within the margin";
}

// b doubles one of two common timings and leaves the other: its geometric mean is sqrt(2). c has the times of a.
TEST(Standings, AreByGeometricMeanOverWhatAllHave) {
  const auto a = timed("a", timing_row("x", 10) + timing_row("y", 10) + timing_row("z", 10));
  const std::vector<Side> others{timed("b", timing_row("x", 20) + timing_row("y", 10) + timing_row("z", 90)),
                                 timed("c", timing_row("x", 10) + timing_row("y", 10))};
  const auto all = standings(compared(a, others));
  ASSERT_EQ(all.size(), 3U);
  EXPECT_EQ(all[0].side->name, "a");
  EXPECT_EQ(all[1].side->name, "c");
  EXPECT_EQ(all[2].side->name, "b");
  EXPECT_EQ(all[1].rank, 1);
  EXPECT_EQ(all[2].rank, 3);
  EXPECT_EQ(all[2].timings, 2U);
  EXPECT_NEAR(all[2].mean_ratio, std::sqrt(2.0), 1e-15);
  EXPECT_TRUE(std::isnan(all[2].mean_normalised));
}

// A bundle without times gets no rank, and the others keep the timings that they have in common.
TEST(Standings, AreOfBundlesWithTimes) {
  const auto a = timed("a", timing_row("x", 10, {.units = "10"}));
  const std::vector<Side> others{side_of("b", {}), timed("c", timing_row("x", 5, {.units = "5"}))};
  const auto all = standings(compared(a, others));
  ASSERT_EQ(all.size(), 3U);
  EXPECT_EQ(all[0].side->name, "c");
  EXPECT_EQ(all[0].timings, 1U);
  EXPECT_NEAR(all[0].mean_ratio, 0.5, 1e-15);
  EXPECT_NEAR(all[0].mean_normalised, 0.5, 1e-15);
  EXPECT_EQ(all[1].rank, 2);
  EXPECT_EQ(all[2].rank, std::nullopt);
  EXPECT_TRUE(std::isnan(all[2].mean_ratio));
  EXPECT_EQ(standings(compared(others[0], {a})).front().rank, std::nullopt);
}

}  // namespace
}  // namespace bezierbench::compare
