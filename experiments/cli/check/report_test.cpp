// SPDX-License-Identifier: MIT
#include "experiments/cli/check/report.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace bezierbench::cli {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

/// A companion method has no bound in the tables, but says of an answer that it keeps its tolerance.
TEST(CheckReport, WhatTheRunFoundIsAFinding) {
  CheckReport report{
      .method = "m", .judged_in = "suite quick", .properties = {}, .cells = {}, .judged = {}, .against = {}};
  EXPECT_THAT(report.findings(), IsEmpty());
  EXPECT_THAT(report.text(false), HasSubstr("nothing wrong was found"));
  report.judged.broken_promises = 3;
  EXPECT_THAT(report.findings(), ElementsAre("what it promises does not hold in 3 trials"));
  report.judged.refuted_proofs = 2;
  report.judged.violations = 7;
  EXPECT_THAT(report.findings(),
              ElementsAre("the bound is violated", "what it promises does not hold in 3 trials", "proofs refuted: 2"));
  EXPECT_THAT(report.text(false), HasSubstr("violated 7 times"));
}

}  // namespace
}  // namespace bezierbench::cli
