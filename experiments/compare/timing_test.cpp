// SPDX-License-Identifier: MIT
#include "experiments/compare/timing.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>

#include "experiments/compare/comparison.hpp"
#include "experiments/compare/side_test.hpp"
#include "experiments/failure.hpp"

namespace bezierbench::compare {
namespace {

using metric::Verdict;

/// One row whose interval extends by `spread` to either side of the median.
std::string row(const std::string& method, double ns, double spread = 0.001, const std::string& quality = "ok",
                const std::string& checked = "yes", const std::string& units = "") {
  return fmt::format("s,bernstein,{},double,2,{},point,{},{},{},{},{},{},{},{}\n", method,
                     method == sentinel ? "" : "4", ns, ns / (1 + spread), ns * (1 + spread), quality, checked, units,
                     units, units);
}

/// The same row with its time in units of the sentinel.
std::string row_in_units(double ns, double units) {
  return row("horner", ns, 0.001, "ok", "yes", fmt::to_string(units));
}

Side timed(const std::string& name, const std::string& rows) {
  return side_of(name, {{timing_file,
                         "study,form,method,scalar,dimension,degree,mode,median_"
                         "ns,low_ns,high_ns,quality,checked,"
                         "sentinel_units,sentinel_units_low,sentinel_units_high\n" +
                             rows}});
}

TimingRow only_row(const std::string& a, const std::string& b) {
  const auto comparison = compare_timing(timed("a", a), timed("b", b));
  EXPECT_FALSE(comparison.rows.empty());
  return comparison.rows.front();
}

TEST(Timing, VerdictsFollowTheInterval) {
  EXPECT_EQ(only_row(row("horner", 10), row("horner", 10)).raw.verdict, Verdict::same);
  EXPECT_EQ(only_row(row("horner", 10), row("horner", 11)).raw.verdict, Verdict::slower);
  EXPECT_EQ(only_row(row("horner", 11), row("horner", 10)).raw.verdict, Verdict::faster);
  EXPECT_EQ(only_row(row("horner", 10, 0.1), row("horner", 11, 0.1)).raw.verdict, Verdict::unresolved);
  EXPECT_DOUBLE_EQ(only_row(row("horner", 10), row("horner", 11)).raw.ratio.median, 1.1);
}

// On a machine that takes 1.5 times as long for everything, methods are slower in nanoseconds and the same in units of the sentinel.
TEST(Timing, InSentinelsASlowMachineIsTheSame) {
  const auto slower = only_row(row_in_units(10, 10), row_in_units(15, 10.005));
  EXPECT_EQ(slower.raw.verdict, Verdict::slower);
  ASSERT_TRUE(slower.normalised);
  EXPECT_EQ(slower.normalised->verdict, Verdict::same);
  EXPECT_DOUBLE_EQ(slower.normalised->ratio.median, 1.0005);
  EXPECT_FALSE(only_row(row_in_units(10, 10), row("horner", 15)).normalised) << "one side has no such unit";
}

TEST(Timing, TheWorseQualityOfBothIsKept) {
  const auto quality = [](const std::string& a, const std::string& b) {
    return only_row(row("horner", 10, 0.001, a), row("horner", 11, 0.001, b)).quality;
  };
  EXPECT_EQ(quality("ok", "ok"), "ok");
  EXPECT_EQ(quality("noisy", "ok"), "noisy");
  EXPECT_EQ(quality("noisy", "few_rounds"), "few_rounds");
  EXPECT_EQ(quality("of_tomorrow", "few_rounds"), "of_tomorrow");
  EXPECT_EQ(only_row(row("horner", 10), row("horner", 11, 0.001, "ok", "no")).quality, "unchecked");
}

/// A side with one time and the times of the two sentinels beside it, on one machine with one build.
Side beside(const std::string& name, double chain_ns, double sweep_ns, const std::string& flags = "-O3") {
  auto side =
      side_of(name, {{timing_file, fmt::format("study,form,method,scalar,dimension,degree,mode,median_ns,low_ns,"
                                               "high_ns,"
                                               "quality,checked,sentinel_ns,sweep_ns\n"
                                               "s,bernstein,horner,double,2,4,point,10,9.99,10.01,ok,yes,{},{}\n",
                                               chain_ns, sweep_ns)}});
  side.facts = {{"cpu.model_name", "x"}, {"build.compiler", "y"}, {"build.flags", flags}};
  return side;
}

TEST(Timing, FixedWorkThatTookLongerInOneOfThemMakesTheRowsNoisy) {
  const auto quality = [](const Side& a, const Side& b) { return compare_timing(a, b).rows.at(0).quality; };
  const auto a = beside("a", 2, 0.5);
  EXPECT_EQ(quality(a, beside("b", 2.03, 0.505)), "ok");
  EXPECT_EQ(quality(a, beside("b", 2.05, 0.5)), "noisy");
  EXPECT_EQ(quality(beside("b", 2, 0.52), a), "noisy");
  EXPECT_EQ(quality(a, beside("b", 2, 0.7, "-O0")), "ok") << "another build may take longer";
  auto other = beside("b", 4, 1);
  other.facts.front().value = "another processor";
  EXPECT_EQ(quality(a, other), "ok") << "another machine may";
}

TEST(Timing, CertainlySlowerIsWhatAllRepetitionsSay) {
  const auto of = [](double spread_a, double spread_b, const std::string& quality = "ok") {
    return only_row(row("horner", 10, spread_a), row("horner", 11, spread_b, quality));
  };
  EXPECT_TRUE(of(0.001, 0.001).is_certainly_slower());
  EXPECT_FALSE(of(0.001, 0.001, "noisy").is_certainly_slower());
  EXPECT_EQ(of(0.055, 0.055).raw.verdict, Verdict::slower);
  EXPECT_FALSE(of(0.055, 0.055).is_certainly_slower()) << "the intervals overlap";
  const auto slow_machine = only_row(row_in_units(10, 10), row_in_units(11, 10));
  EXPECT_EQ(slow_machine.raw.verdict, Verdict::slower);
  EXPECT_FALSE(slow_machine.is_certainly_slower()) << "not in units of the sentinel";
}

TEST(Timing, TooFewRoundsDecideNothing) {
  EXPECT_EQ(only_row(row("horner", 10, 0.001, "few_rounds"), row("horner", 20)).raw.verdict, Verdict::unresolved);
}

// A rank counts the methods that are certainly faster: neighbours with overlapping intervals share a rank.
TEST(Timing, RanksAreOfTheCertainlyFaster) {
  const auto comparison = compare_timing(timed("a", row("x", 10) + row("y", 20) + row("z", 20.01) + row("sentinel", 1)),
                                         timed("b", row("x", 30) + row("y", 20) + row("z", 25) + row("sentinel", 1)));
  std::vector<int> ranks;
  for (const auto& one : comparison.rows) {
    ranks.push_back(one.rank_a);
    ranks.push_back(one.rank_b);
  }
  EXPECT_EQ(ranks, (std::vector<int>{1, 3, 2, 1, 2, 2, 0, 0}));
}

/// The methods that changed their place.
std::string changed(const std::string& a, const std::string& b) {
  std::string methods;
  for (const auto& one : compare_timing(timed("a", a), timed("b", b)).rows)
    if (one.changed_place) methods += one.inputs.field("method");
  return methods;
}

TEST(Timing, PlacesChangeOnlyWhereBothSidesResolveTheRatio) {
  const std::string ahead = row("x", 10) + row("y", 12);
  EXPECT_EQ(changed(ahead, row("x", 12) + row("y", 10)), "xy");
  EXPECT_EQ(changed(ahead, row("x", 20) + row("y", 30)), "");
  EXPECT_EQ(changed(ahead, row("x", 12, 0.2) + row("y", 10, 0.2)), "") << "the second side cannot tell";
  EXPECT_EQ(changed(ahead, row("x", 10.05) + row("y", 10)), "") << "within the margin";
}

// c has no y, so neither pair ranks y, and x has the same rank in a whichever bundle a is compared with.
TEST(Timing, RanksOfSeveralBundlesAreAmongWhatAllHave) {
  const auto a = timed("a", row("x", 20) + row("y", 10) + row("z", 15));
  std::vector<Pair> pairs{compare_pair(a, timed("b", row("x", 20) + row("y", 10) + row("z", 15))),
                          compare_pair(a, timed("c", row("x", 20) + row("z", 15)))};
  EXPECT_EQ(pairs[0].timing.rows[0].rank_a, 3);
  rank_in_all(pairs);
  std::vector<int> ranks;
  for (const auto& pair : pairs)
    for (const auto& one : pair.timing.rows) ranks.push_back(one.rank_a);
  EXPECT_EQ(ranks, (std::vector<int>{2, 0, 1, 2, 1}));
}

TEST(Timing, ATimeThatIsNotANumberNamesItsLine) {
  try {
    (void)compare_timing(timed("a", row("horner", 10)),
                         timed("b", "s,bernstein,horner,double,2,4,point,,1,1,ok,yes,,,\n"));
    FAIL();
  } catch (const Failure& failure) {
    EXPECT_EQ(failure.exit(), Exit::input_output);
    EXPECT_TRUE(std::string(failure.what()).starts_with("b/timing.csv:2: median_ns")) << failure.what();
  }
}

// b doubles one of two common timings and leaves the other: its geometric mean is sqrt(2). c has the times of a.
TEST(Standings, AreByGeometricMeanOverWhatAllHave) {
  const auto a = timed("a", row("x", 10) + row("y", 10) + row("z", 10));
  const std::vector<Side> others{timed("b", row("x", 20) + row("y", 10) + row("z", 90)),
                                 timed("c", row("x", 10) + row("y", 10))};
  const std::vector<Pair> pairs{compare_pair(a, others[0]), compare_pair(a, others[1])};
  const auto all = standings(a, others, pairs);
  ASSERT_EQ(all.size(), 3U);
  EXPECT_EQ(all[0].bundle, "a");
  EXPECT_EQ(all[1].bundle, "c");
  EXPECT_EQ(all[2].bundle, "b");
  EXPECT_EQ(all[0].rank, 1);
  EXPECT_EQ(all[1].rank, 1);
  EXPECT_EQ(all[2].rank, 3);
  EXPECT_EQ(all[2].timings, 2U);
  EXPECT_NEAR(all[2].mean_ratio, std::sqrt(2.0), 1e-15);
  EXPECT_TRUE(std::isnan(all[2].mean_normalised));
}

// A bundle without timing gets no rank, and the others keep the timings that they have in common.
TEST(Standings, AreOfBundlesWithTimes) {
  const auto a = timed("a", row("x", 10, 0.001, "ok", "yes", "10"));
  const std::vector<Side> others{side_of("b", {}), timed("c", row("x", 5, 0.001, "ok", "yes", "5"))};
  const std::vector<Pair> pairs{compare_pair(a, others[0]), compare_pair(a, others[1])};
  const auto all = standings(a, others, pairs);
  ASSERT_EQ(all.size(), 3U);
  EXPECT_EQ(all[0].bundle, "c");
  EXPECT_EQ(all[0].rank, 1);
  EXPECT_EQ(all[0].timings, 1U);
  EXPECT_NEAR(all[0].mean_ratio, 0.5, 1e-15);
  EXPECT_NEAR(all[0].mean_normalised, 0.5, 1e-15);
  EXPECT_EQ(all[1].bundle, "a");
  EXPECT_EQ(all[1].rank, 2);
  EXPECT_EQ(all[2].bundle, "b");
  EXPECT_EQ(all[2].rank, std::nullopt);
  EXPECT_TRUE(std::isnan(all[2].mean_ratio));

  const auto timeless = standings(others[0], {a}, {compare_pair(others[0], a)});
  EXPECT_EQ(timeless[0].rank, std::nullopt);
  EXPECT_EQ(timeless[1].rank, std::nullopt);
}

}  // namespace
}  // namespace bezierbench::compare
