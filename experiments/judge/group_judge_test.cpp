// SPDX-License-Identifier: MIT
#include "experiments/judge/group_judge.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

namespace bezierbench::judge {
namespace {

/// Judges four trials of degree 30, whose points are all NaN, as those of `horner_bernstein`.
Judgement judged_without_a_number(double range) {
  suite::Study study;
  study.id = "s";
  study.trials = 4;
  sample::Cell cell;
  cell.degree = 30;
  cell.coordinate_range = range;
  const sample::Sampler sampler(1, study.id, cell);
  const JudgedMethods<double> methods(study, cell, *find_kernel<double>("horner_bernstein", Form::bernstein, 2));
  const GroupJudge<double> judge(study, cell, sampler, methods, reference::Tier::certified, 0);
  CellTally block;
  block.judgements.resize(methods.judgement_count());
  judge.judge({0, 0}, std::vector<double>(8, std::numeric_limits<double>::quiet_NaN()), block);
  return block.judgements.front();
}

TEST(GroupJudge, APointThatIsNotFiniteBreaksEveryFiniteBound) {
  const auto judgement = judged_without_a_number(1e290);
  EXPECT_EQ(judgement.non_finite, 4U);
  EXPECT_EQ(judgement.bounded, 4U);
  EXPECT_EQ(judgement.violations.count, 4U);
}

/// C(30,15) is above 2^27, so C(n,i) b_i leaves the range.
TEST(GroupJudge, WhereAResultMayOverflowNothingIsBroken) {
  const auto judgement = judged_without_a_number(0x1p+1020);
  EXPECT_EQ(judgement.non_finite, 4U);
  EXPECT_EQ(judgement.bounded, 0U);
  EXPECT_EQ(judgement.violations.count, 0U);
}

}  // namespace
}  // namespace bezierbench::judge
