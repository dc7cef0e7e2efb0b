// SPDX-License-Identifier: MIT
#include "experiments/run/progress.hpp"

#include <gtest/gtest.h>

namespace bezierbench::run {
namespace {

TEST(ProgressState, NamesTheStudyAndItsShare) {
  ProgressState state({{"a", 2, 100, false}, {"b", 4, 300, false}});
  state.add(1, 75, 3);
  const auto view = state.view();
  EXPECT_EQ(view.study, "b");
  EXPECT_DOUBLE_EQ(view.share, 75.0 / 400);
  EXPECT_EQ(view.studies_done, 0U);
  EXPECT_EQ(view.studies, 2U);
}

TEST(ProgressState, TimeLeftFollowsTheTimeThatWasTaken) {
  ProgressState state({{"a", 4, 400, false}});
  state.add(0, 100, 3);
  EXPECT_DOUBLE_EQ(state.view().left, 9);
  state.add(0, 100, 4);
  EXPECT_DOUBLE_EQ(state.view().left, 4);
}

// Timings have one thread, the others all: what one phase took does not determine the other.
TEST(ProgressState, TimingsHaveAPaceOfTheirOwn) {
  constexpr double claimed = 1e9;  // the cost of what is to take a second
  ProgressState state({{"a", 2, 8 * claimed, false}, {"t", 2, 10 * claimed, true}});
  state.add(0, 4 * claimed, 1);
  EXPECT_DOUBLE_EQ(state.view().left, 1 + 10);
  state.add(0, 4 * claimed, 2);
  EXPECT_EQ(state.view().studies_done, 1U);
  state.add(1, 5 * claimed, 22);
  EXPECT_DOUBLE_EQ(state.view().left, 20);
  state.add(1, 5 * claimed, 42);
  EXPECT_DOUBLE_EQ(state.view().left, 0);
  EXPECT_DOUBLE_EQ(state.view().share, 1);
  EXPECT_EQ(state.view().studies_done, 2U);
}

TEST(ProgressState, WhatAnEarlierRunFinishedIsDone) {
  ProgressState state({{"a", 0, 0, false}, {"b", 1, 5, false}});
  EXPECT_EQ(state.view().studies_done, 1U);
  state.add(1, 5, 1);
  EXPECT_EQ(state.view().studies_done, 2U);
}

TEST(ProgressText, Durations) {
  EXPECT_EQ(duration(0), "0 s");
  EXPECT_EQ(duration(59.4), "59 s");
  EXPECT_EQ(duration(59.6), "1 min 00 s");
  EXPECT_EQ(duration(3599), "59 min 59 s");
  EXPECT_EQ(duration(2 * 3600 + 5 * 60 + 59), "2 h 05 min");
}

TEST(ProgressText, Line) {
  const ProgressView view{"2.3.1", 0.999, 4, 11, 63};
  EXPECT_EQ(progress_line(view), " 99 %, about 1 min 03 s left, 2.3.1 (4 of 11 studies done)");
}

TEST(ProgressText, Ending) {
  Outcome outcome;
  outcome.ending = Ending::complete;
  outcome.cells = 154;
  outcome.times = 120;
  outcome.ratio_width = 0.034;
  outcome.seconds = 48;
  EXPECT_EQ(ending_line(outcome),
            "complete in 48 s: 154 cells, no bound violated, 120 times, the intervals of their "
            "ratios 3.4 % wide in the median");
  outcome.findings = {"bound violated 7 times"};
  outcome.cells = 1;
  outcome.violations = 7;
  outcome.times = 0;
  EXPECT_EQ(ending_line(outcome), "complete in 48 s: 1 cell, bounds violated 7 times");
  outcome.refuted_proofs = 1;
  EXPECT_EQ(ending_line(outcome), "complete in 48 s: 1 cell, bounds violated 7 times, 1 proof refuted");
  outcome.broken_promises = 2;
  outcome.violations = 0;
  outcome.refuted_proofs = 3;
  EXPECT_EQ(ending_line(outcome), "complete in 48 s: 1 cell, promises broken 2 times, 3 proofs refuted");
}

}  // namespace
}  // namespace bezierbench::run
