// SPDX-License-Identifier: MIT
#include "experiments/compare/comparison.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <vector>

#include "experiments/compare/side_test.hpp"
#include "experiments/failure.hpp"
#include "experiments/metric/order_statistics.hpp"

namespace bezierbench::compare {
namespace {

constexpr const char* accuracy =
    "study,method,degree,trials,status,mean_error,max_error\n"
    "s,horner,3,10,ok,1e-17,3e-17\n"
    "s,direct,3,10,ok,1e-17,4e-17\n";
constexpr const char* worst =
    "worst_id,study,method,degree,trial,t,coefficients\n"
    "w1,s,horner,3,7,0x1p-1,0x1p+0\n"
    "w2,s,direct,3,8,0x1p-2,0x1p+3 0x1p+4\n";

std::string replaced(std::string text, const std::string& old, const std::string& fresh) {
  return text.replace(text.find(old), old.size(), fresh);
}

TEST(Results, RowsOfOneSideAreListedNotJudged) {
  const auto a = side_of("a", {{"accuracy.csv", accuracy}});
  const auto b = side_of("b", {{"accuracy.csv", std::string(accuracy) + "s,estrin,3,10,ok,0,0\n"},
                               {"conversion.csv", "study,conversion\nc,exact\n"}});
  const auto comparison = compare_sides(a, b);
  EXPECT_TRUE(comparison.differing().empty());
  EXPECT_TRUE(comparison.only_a.empty());
  ASSERT_EQ(comparison.only_b.size(), 2U);
  EXPECT_EQ(comparison.only_b[0].inputs.field("method"), "estrin");
  EXPECT_EQ(comparison.only_b[1].file, "conversion.csv") << "a table that is missing in a";
  EXPECT_EQ(comparison.only_b[1].inputs.field("method"), "exact");
  EXPECT_EQ(recorded_input(a, comparison.results.front().inputs), "");
}

TEST(Results, OtherTrialsOrAnotherSeedAreOtherInputs) {
  const auto a = side_of("a", {{"accuracy.csv", accuracy}});
  const auto more = side_of("b", {{"accuracy.csv", replaced(accuracy, "3,10,ok", "3,20,ok")}});
  EXPECT_EQ(compare_sides(a, more).results.size(), 1U);
  auto seeded = a;
  seeded.manifest.seed = 2;
  EXPECT_TRUE(compare_sides(a, seeded).results.empty());
}

/// The rows that differ; `a` and `b` are rows of study, method, degree, mean and largest error.
std::vector<Row> differing(const std::string& a, const std::string& b) {
  const std::string header = "study,method,degree,mean_error,max_error_u\n";
  const auto side_a = side_of("a", {{"accuracy.csv", header + a}});
  const auto side_b = side_of("b", {{"accuracy.csv", header + b}});
  const auto comparison = compare_sides(side_a, side_b);
  std::vector<Row> rows;
  for (const auto* row : comparison.differing()) rows.push_back(*row);
  return rows;
}

TEST(Results, ShowTheLargestErrorIfItDiffers) {
  EXPECT_EQ(differing("s,x,3,1,2\n", "s,x,3,5,3\n").front().column, "max_error_u");
  EXPECT_EQ(differing("s,x,3,1,2\n", "s,x,3,5,2\n").front().column, "mean_error");
}

TEST(Results, ThatAreNotNumbersAreTheWorst) {
  EXPECT_EQ(differing("s,x,3,1,2\n", "s,x,3,1,nan\n").front().growth(), std::numeric_limits<double>::infinity());
  EXPECT_EQ(differing("s,x,3,1,0\n", "s,x,3,1,2\n").front().growth(), std::numeric_limits<double>::infinity());
}

TEST(Times, VerdictsFollowTheInterval) {
  const auto verdict = [](const std::string& a, const std::string& b) { return only_row(a, b).verdict; };
  EXPECT_EQ(verdict(timing_row("x", 10), timing_row("x", 10)), "same");
  EXPECT_EQ(verdict(timing_row("x", 10), timing_row("x", 11)), "slower");
  EXPECT_EQ(verdict(timing_row("x", 11), timing_row("x", 10)), "faster");
  EXPECT_EQ(verdict(timing_row("x", 10, {.spread = 0.1}), timing_row("x", 11, {.spread = 0.1})), "unresolved");
  EXPECT_EQ(verdict(timing_row("x", 10, {.quality = "few_rounds"}), timing_row("x", 20)), "unresolved");
  EXPECT_DOUBLE_EQ(only_row(timing_row("x", 10), timing_row("x", 11)).ratio.median, 1.1);
}

// On a machine that takes 1.5 times as long for everything, methods are slower in nanoseconds and the same in units of
// the sentinel.
TEST(Times, OfAnotherMachineAreJudgedInSentinels) {
  const auto row = [](const std::string& units_a, const std::string& units_b, const std::string& processor) {
    auto a = timed("a", timing_row("x", 10, {.units = units_a}));
    auto b = timed("b", timing_row("x", 15, {.units = units_b}));
    a.facts = {{"cpu.model_name", "one"}};
    b.facts = {{"cpu.model_name", processor}};
    return compare_sides(a, b).times.at(0);
  };
  EXPECT_EQ(row("10", "10.005", "another").verdict, "same");
  EXPECT_DOUBLE_EQ(row("10", "10.005", "another").timed->judged.median, 1.0005);
  EXPECT_EQ(row("10", "", "another").verdict, "slower") << "one side has no such unit";
  EXPECT_EQ(row("10", "10.005", "one").verdict, "unresolved") << "one machine that changed its speed";
  EXPECT_EQ(row("10", "15", "one").verdict, "slower");
}

TEST(Times, TheWorseQualityOfBothIsKept) {
  const auto quality = [](const std::string& a, const std::string& b, const std::string& checked = "yes") {
    return only_row(timing_row("x", 10, {.quality = a}), timing_row("x", 11, {.quality = b, .checked = checked}))
        .timed->quality;
  };
  EXPECT_EQ(quality("ok", "ok"), "ok");
  EXPECT_EQ(quality("few_rounds", "ok"), "few_rounds");
  EXPECT_EQ(quality("of_tomorrow", "few_rounds"), "of_tomorrow");
  EXPECT_EQ(quality("ok", "ok", "no"), "unchecked");
  EXPECT_EQ(only_row(timing_row("x", 10, {.checked = "no"}), timing_row("x", 20)).verdict, "unresolved");
}

TEST(Times, ATimeThatIsNotANumberNamesItsLine) {
  try {
    only_row(timing_row("x", 10), "s,x,,1,1,ok,yes,,,\n");
    FAIL();
  } catch (const Failure& failure) {
    EXPECT_EQ(failure.exit(), Exit::input_output);
    EXPECT_TRUE(std::string(failure.what()).starts_with("b/timing.csv:2: median_ns")) << failure.what();
  }
}

using metric::Interval;

constexpr double close = 1e-14;

void expect_close(const Interval& ours, const Interval& theirs) {
  EXPECT_NEAR(ours.median / theirs.median, 1, close);
  EXPECT_NEAR(ours.low / theirs.low, 1, close);
  EXPECT_NEAR(ours.high / theirs.high, 1, close);
}

Interval inverse(const Interval& x) { return {1 / x.median, 1 / x.high, 1 / x.low}; }

// With one time known exactly, the ratio's interval is the other's interval divided by it.
TEST(Ratio, OfAKnownTimeIsTheOthersInterval) {
  expect_close(ratio({6, 5, 8}, {2, 2, 2}), {3, 2.5, 4});
  expect_close(ratio({2, 2, 2}, {6, 5, 8}), {1.0 / 3, 0.25, 0.4});
}

// Limits that are factors of e^3 and e^4 away combine to a factor of e^5. The lower limit of b goes with the upper one
// of a.
TEST(Ratio, DistancesAddInSquares) {
  const double e = std::exp(1.0);
  const Interval b{7, 7 / std::pow(e, 3), 7 * std::pow(e, 5)};
  const Interval a{2, 2 / std::pow(e, 12), 2 * std::pow(e, 4)};
  expect_close(ratio(b, a), {3.5, 3.5 / std::pow(e, 5), 3.5 * std::pow(e, 13)});
}

TEST(Ratio, SwappingGivesTheReciprocal) {
  const Interval a{31, 30, 37};
  const Interval b{22, 21.5, 22.1};
  expect_close(ratio(a, b), inverse(ratio(b, a)));
}

TEST(Ratio, NoTimeIsUnresolved) {
  EXPECT_EQ(metric::verdict(ratio({1, 0, 2}, {1, 1, 1})), metric::Verdict::unresolved);
  EXPECT_EQ(metric::verdict(ratio({1, 1, 1}, {-1, -1, -1})), metric::Verdict::unresolved);
  EXPECT_EQ(metric::verdict(ratio({1, 2, 1}, {1, 1, 1})), metric::Verdict::unresolved);
}

/// Simulated times of a run; their distribution is skewed, as that of measured times.
std::vector<double> run(std::mt19937_64& words, double scale) {
  std::vector<double> times(101);
  const auto time = [&] { return scale * (1 + std::pow(static_cast<double>(words() >> 11U) * 0x1p-53, 4)); };
  std::ranges::generate(times, time);
  return times;
}

// The medians' intervals cover 99 %, and so must the ratio's: less than 1 % of 4000 runs may miss the truth. The limit
// in the test leaves three standard deviations of that count.
TEST(Ratio, CoversTheTruth) {
  std::mt19937_64 words{1};
  constexpr int runs = 4000;
  int missed = 0;
  for (int k = 0; k < runs; ++k) {
    const auto a = metric::median_interval(run(words, 2), metric::timing_confidence);
    const auto b = metric::median_interval(run(words, 3), metric::timing_confidence);
    const auto found = ratio(b, a);
    if (found.low > 1.5 || found.high < 1.5) ++missed;
  }
  EXPECT_LE(missed, 40 + 3 * std::sqrt(40.0));
  EXPECT_GT(missed,
            0);  // an interval that is never wrong is too wide to be of use
}

}  // namespace
}  // namespace bezierbench::compare
