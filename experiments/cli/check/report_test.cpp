// SPDX-License-Identifier: MIT
#include "experiments/cli/check/report.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <vector>

namespace bezierbench::cli {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

TEST(Report, SaysTheVerdictFirstAndThreeDetailsOfALine) {
  Report report{.method = "m"};
  report.add("a", "one", {"a1", "a2", "a3", "a4"});
  report.add("b", "two");
  EXPECT_EQ(report.text(),
            "verdict     m: no problem was found\n"
            "a           one; 1 more with --all\n"
            "            a1\n"
            "            a2\n"
            "            a3\n"
            "b           two\n");
  Report whole{.method = "m", .all = true};
  whole.add("a", "one", {"a1", "a2", "a3", "a4"});
  EXPECT_THAT(whole.text(), HasSubstr("a           one\n"));
  EXPECT_THAT(whole.text(), HasSubstr("            a4\n"));
}

/// A companion method has no bound in the tables, but says of an answer that it keeps its tolerance.
TEST(Report, WhatTheRunFoundIsAFinding) {
  Report report{.method = "m"};
  report.add_bound({}, {});
  EXPECT_TRUE(report.findings.empty());
  run::Outcome outcome;
  outcome.violations = 7;
  outcome.broken_promises = 3;
  outcome.refuted_proofs = 2;
  report.add_bound({}, outcome);
  EXPECT_THAT(report.findings,
              ElementsAre("the bound is violated", "the guarantee does not hold in 3 trials", "2 proofs are refuted"));
  EXPECT_THAT(report.text(), HasSubstr("violated 7 times"));
}

/// The inputs of a row of timing.csv.
compare::Inputs at_degree(int degree) {
  const auto table = bundle::parse_csv("study,degree\ns," + std::to_string(degree) + "\n", "timing.csv");
  return {*bundle::declared_table("timing.csv"), table, 0, table};
}

/// Times of the method, pair by pair: before, and after as a multiple of it.
PairedTimes times_with(double factor, bool checked = true) {
  return {std::vector<double>(8, 10), std::vector<double>(8, factor * 10), checked};
}

TEST(Report, WrongTimesAreFindings) {
  Report report{.method = "m"};
  report.add_times({{at_degree(1), times_with(1)}, {at_degree(2), times_with(0.5)}}, 8);
  EXPECT_TRUE(report.findings.empty());
  report.lines.clear();
  report.add_times({{at_degree(1), times_with(1)}, {at_degree(2), times_with(2)}, {at_degree(3), times_with(1, false)}},
                   8);
  EXPECT_THAT(report.findings, ElementsAre("timed results differ from the judged ones")) << "gates judge the others";
  EXPECT_THAT(report.text(), HasSubstr("degree 2"));
  EXPECT_THAT(report.text(), HasSubstr("degree 3, wrong results"));
  EXPECT_THAT(report.text(), testing::Not(HasSubstr("degree 1"))) << "its time is the same";
}

using metric::Verdict;

/// Pairs that the machine disturbed alike: each takes another time, and so does its partner.
PairedTimes after_times(double factor, std::size_t pairs) {
  PairedTimes times;
  for (std::size_t k = 0; k < pairs; ++k) {
    const double disturbed = 10 * (1 + static_cast<double>(k * k % 7));
    times.before.push_back(disturbed);
    times.after.push_back(factor * disturbed);
  }
  return times;
}

TEST(PairedTimes, AreJudgedByTheirRatios) {
  EXPECT_EQ(after_times(1, 12).verdict(), Verdict::same);
  EXPECT_EQ(after_times(1.02, 12).verdict(), Verdict::slower);
  EXPECT_EQ(after_times(0.98, 12).verdict(), Verdict::faster);
  EXPECT_DOUBLE_EQ(after_times(1.02, 12).ratio().median, 1.02);
}

TEST(PairedTimes, RequireEnoughPairsForAnInterval) {
  EXPECT_EQ(after_times(2, 7).verdict(), Verdict::unresolved);
  EXPECT_EQ(after_times(2, 8).verdict(), Verdict::slower);
}

TEST(PairedTimes, OnePairOfTwelveDecidesNothing) {
  PairedTimes times{std::vector<double>(12, 10), std::vector<double>(12, 10)};
  times.after[3] = 1000;
  EXPECT_EQ(times.verdict(), Verdict::same);
}

}  // namespace
}  // namespace bezierbench::cli
