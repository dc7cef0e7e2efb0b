// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include "experiments/number/number.hpp"
#include "experiments/studies/length_study_test.hpp"
#include "experiments/studies/roster.hpp"

namespace bezierbench::studies {
namespace {

suite::Study small_inverse_arc_length_study() {
  auto study = small_length_study("inverse_arc_length", {"cusp", "integer"});
  study.t_interval = {{0.25, 0.75}};  // true parameters take longer than true lengths
  return study;
}

TEST(InverseArcLengthStudy, OrderAndInterruptionsChangeNoByteAndPromisesAreKept) {
  const auto tables = run::expect_order_changes_nothing(make_job, small_inverse_arc_length_study());
  const auto csv = bundle::parse_csv(tables.at("inverse_arc_length.csv"), "inverse_arc_length.csv");
  ASSERT_EQ(csv.row_count(), 2U * 2 * 4);
  for (std::size_t row = 0; row < csv.row_count(); ++row) {
    expect_kept(csv, row);
    EXPECT_LE(*number::parse_number(csv.at(row, "mean_iterations")),
              *number::parse_number(csv.at(row, "max_iterations")));
    if (csv.at(row, "method") == "bracketed_newton") {
      EXPECT_EQ(csv.at(row, "non_converged"), "0");
      EXPECT_EQ(csv.at(row, "outside"), "0");
    }
  }
}

/// The gaps are even at equal lengths and uneven at equal steps of t; the shares go from 0 to 1.
TEST(InverseArcLengthStudy, WritesOneCurveWithBothSpacings) {
  auto study = small_inverse_arc_length_study();
  study.trials = 1;
  const auto job = make_job(study, {1});
  run::run_all(*job);
  const auto csv = bundle::parse_csv(run::text_of(*job).at("spacing.csv"), "spacing.csv");
  ASSERT_EQ(csv.row_count(), 201U + 21 + 21);
  double widest = 0;
  for (std::size_t row = 0; row < csv.row_count(); ++row) {
    EXPECT_EQ(csv.at(row, "study"), "small");
    EXPECT_EQ(csv.at(row, "z"), "");
    if (csv.at(row, "spacing") == "outline") continue;
    if (csv.at(row, "index") == "0") {
      EXPECT_EQ(csv.at(row, "share"), "0");
      EXPECT_EQ(csv.at(row, "gap"), "");
      continue;
    }
    const double gap = *number::parse_number(csv.at(row, "gap"));
    if (csv.at(row, "spacing") == "arc_length") {
      EXPECT_NEAR(gap, 1, 1e-12);
      EXPECT_NEAR(*number::parse_number(csv.at(row, "share")), std::stod(csv.at(row, "index")) / 20, 1e-12);
    }
    if (csv.at(row, "spacing") == "parameter") widest = std::max(widest, gap);
  }
  EXPECT_GT(widest, 1.5);
}

}  // namespace
}  // namespace bezierbench::studies
