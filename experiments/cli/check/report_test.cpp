// SPDX-License-Identifier: MIT
#include "experiments/cli/check/report.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <vector>

namespace bezierbench::cli {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

TEST(Report, SaysTheVerdictFirstAndThreeDetailsOfASection) {
  const Report report{.method = "m", .sections = {{"a", "one", {"a1", "a2", "a3", "a4"}}, {"b", "two"}}};
  EXPECT_EQ(report.text(false),
            "verdict     m: no problem was found\n"
            "a           one; 1 more with --all\n"
            "            a1\n"
            "            a2\n"
            "            a3\n"
            "b           two\n");
  EXPECT_THAT(report.text(true), HasSubstr("a           one\n"));
  EXPECT_THAT(report.text(true), HasSubstr("            a4\nb "));
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
  EXPECT_THAT(report.text(false), HasSubstr("violated 7 times"));
}

/// A time of the method, pair by pair: before, and after as a multiple of it.
PairedTime time_with(double factor, bool right = true) {
  auto time = paired_time({}, std::vector<double>(8, 10), std::vector<double>(8, factor * 10));
  time.right = right;
  return time;
}

TEST(Report, SlowerOrWrongTimesAreFindings) {
  Report report{.method = "m"};
  report.add_times({time_with(1), time_with(0.5)}, 8, false);
  EXPECT_TRUE(report.findings.empty());
  report.add_times({time_with(1), time_with(2), time_with(1, false)}, 8, false);
  EXPECT_THAT(report.findings, ElementsAre("slower in 1 of 3 races", "timed results differ from the judged ones"));
  EXPECT_EQ(report.sections.back().details.size(), 2U) << "without the one that is the same";
}

}  // namespace
}  // namespace bezierbench::cli
