// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <algorithm>

#include "experiments/studies/flattening/problem.hpp"
#include "experiments/studies/study_test.hpp"

namespace bezierbench::studies {
namespace {

TEST(FlatteningStudy, CountsNoFewerChordsThanTheLeastWhereTheToleranceIsKept) {
  auto study = small_study("flattening");
  study.degree = {2, 3};
  study.tolerance = {0.1, 1e-3};
  study.trials = 20;
  const auto csv = rows_of(study, "flattening.csv");
  const auto polynomial =
      std::ranges::count(flatten_kernels(2), Form::bernstein, [](auto& one) { return one.info->form; });
  ASSERT_EQ(csv.row_count(), 2 * 2 * static_cast<std::size_t>(polynomial));
  int kept = 0;
  for (std::size_t row = 0; row < csv.row_count(); ++row) {
    if (csv.at(row, "status") != "ok") continue;
    EXPECT_LE(run::number_at(csv, row, "least_low"), run::number_at(csv, row, "least_high"));
    EXPECT_LE(run::number_at(csv, row, "least_high"), 1.1 * run::number_at(csv, row, "least_low"));
    EXPECT_EQ(csv.at(row, "malformed"), "0");
    const bool broken = csv.at(row, "broken") != "0";
    EXPECT_EQ(broken, !csv.at(row, "worst_curve").empty());
    EXPECT_EQ(broken, run::number_at(csv, row, "max_error_over_tolerance") > 1);
    if (broken) continue;
    EXPECT_GE(run::number_at(csv, row, "mean_chords"), run::number_at(csv, row, "least_low"));
    ++kept;
    if (csv.at(row, "method") == "equal_errors") {
      EXPECT_EQ(csv.at(row, "reversed_apart"), "0");
    }
  }
  EXPECT_GT(kept, 20);
}

/// The parabola (0, 0), (1, 2), (2, 0): one chord is 1 away, two are right for a tolerance of 1/8 of its size 2.
class JudgedParabola : public testing::Test {
 protected:
  JudgedParabola() {
    drawn_.trial.coefficients = {0, 0, 1, 2, 2, 0};
    drawn_.curve = {Form::bernstein, 2, 2, drawn_.trial.coefficients};
    drawn_.size = 2;
    drawn_.reversed = {2, 0, 1, 2, 0, 0};
    drawn_.scaled.emplace(drawn_.curve);
  }
  FlatteningErrors judged(const Flattening& chords) {
    FlatteningErrors errors;
    auto promising = flatten_kernels(2).front();
    promising.keeps_tolerance = true;
    FlatteningProblem::judge(promising, drawn_, 0.125, chords, 7, errors);
    return errors;
  }

  FlatteningProblem::Drawn drawn_;
};

TEST_F(JudgedParabola, ABrokenToleranceBreaksThePromiseAndNamesTheCurve) {
  Flattening chords;
  chords.t = {0, 1};
  chords.points = {0, 0, 2, 0};
  auto errors = judged(chords);
  EXPECT_EQ(errors.broken.count, 1U);
  EXPECT_EQ(errors.broken_promises.first, 7U);
  EXPECT_NEAR(errors.worst.over_tolerance, 4, 0.01);
  EXPECT_EQ(worst_curve(errors), tables::Field(std::string("0x0p+0 0x0p+0 0x1p+0 0x1p+1 0x1p+1 0x0p+0")));
  chords.complete = false;
  errors = judged(chords);
  EXPECT_EQ(errors.broken.count, 1U);
  EXPECT_EQ(errors.broken_promises.count, 0U);
  EXPECT_EQ(errors.incomplete, 1U);
}

TEST_F(JudgedParabola, TheToleranceItselfIsKept) {
  Flattening chords;
  chords.t = {0, 0.5, 1};
  chords.points = {0, 0, 1, 1, 2, 0};
  const auto errors = judged(chords);
  EXPECT_EQ(errors.broken.count + errors.undecided.count + errors.malformed.count, 0U);
  EXPECT_EQ(errors.chords.sum, 2U);
  EXPECT_EQ(errors.least_low.sum, 2U);
  EXPECT_EQ(errors.least_high.sum, 2U);
}

TEST_F(JudgedParabola, ChordsThatDoNotLeadFromEndToEndAreMalformed) {
  Flattening chords;
  chords.t = {0, 0.5, 1};
  chords.points = {0, 0, 1, 1, 2, 0x1p-1000};
  EXPECT_EQ(judged(chords).malformed.count, 1U);
  chords.points.back() = 0;
  chords.t = {0, 0.5, 0.25, 1};
  EXPECT_EQ(judged(chords).malformed.count, 1U);
}

}  // namespace
}  // namespace bezierbench::studies
