// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include "experiments/failure.hpp"
#include "experiments/run/job_test.hpp"
#include "experiments/studies/roster.hpp"

namespace bezierbench::studies {
namespace {

suite::Study small_grid_study() {
  suite::Study study;
  study.id = "small";
  study.kind = &kind("grid");
  study.points = {17, 257};
  study.degree = {3, 10};
  study.trials = 20;  // two blocks, the last one short
  return study;
}

bundle::CsvDocument grid_rows_of(const suite::Study& study) {
  const auto job = make_job(study, {1});
  run::run_all(*job);
  EXPECT_TRUE(job->violations().empty());
  return bundle::parse_csv(run::text_of(*job).at("grid.csv"), "grid.csv");
}

TEST(GridStudy, OrderAndInterruptionsChangeNoByte) {
  const auto files = run::expect_order_changes_nothing(make_job, small_grid_study());
  EXPECT_EQ(make_job(small_grid_study(), {1})->extent().rows,
            bundle::parse_csv(files.at("grid.csv"), "grid.csv").row_count());
}

TEST(GridStudy, BoundsHoldAndOnlyForwardDifferencingLosesByTheNumberOfPoints) {
  const auto csv = grid_rows_of(small_grid_study());
  ASSERT_EQ(csv.row_count(), 2U * 2 * 3);
  double coarse = 0;
  for (std::size_t row = 0; row < csv.row_count(); ++row) {
    EXPECT_EQ(csv.at(row, "bound_violations"), "0");
    EXPECT_EQ(csv.at(row, "non_finite"), "0");
    const double error = run::number_at(csv, row, "max_error_u");
    EXPECT_GT(error, 0);
    EXPECT_LE(error, run::number_at(csv, row, "bound_u"));
    EXPECT_GE(error, run::number_at(csv, row, "max_last_error_u"));
    if (csv.at(row, "degree") != "3" || csv.at(row, "method") != "forward_differencing") continue;
    if (csv.at(row, "points") == "17")
      coarse = error;
    else
      EXPECT_GT(error, 4 * coarse);
  }
  EXPECT_GT(coarse, 0);
}

TEST(GridStudy, TakesTheMethodsOfTheForm) {
  auto study = small_grid_study();
  study.form = Form::power;
  EXPECT_EQ(grid_rows_of(study).row_count(), 2U * 2 * 2);
}

TEST(GridStudy, RefusesWhatItCannotDo) {
  auto rational = small_grid_study();
  rational.form = Form::rational;
  EXPECT_THROW(make_job(rational, {1}), Failure);
  auto single = small_grid_study();
  single.scalar = {suite::ScalarKind::float32};
  EXPECT_THROW(make_job(single, {1}), Failure);
  auto uneven = small_grid_study();
  uneven.kind = &kind("grid");
  uneven.points = {16};
  EXPECT_THROW(run::run_all(*make_job(uneven, {1})), Failure);
}

}  // namespace
}  // namespace bezierbench::studies
