// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include "experiments/studies/study_test.hpp"

namespace bezierbench::studies {
namespace {

suite::Study small_grid_study() {
  auto study = small_study("grid");
  study.points = {17, 257};
  study.degree = {3, 10};
  study.trials = 20;
  return study;
}

TEST(GridStudy, BoundsHoldAndOnlyForwardDifferencingLosesByTheNumberOfPoints) {
  const auto csv = rows_of(small_grid_study(), "grid.csv");
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
  EXPECT_EQ(rows_of(study, "grid.csv").row_count(), 2U * 2 * 2);
}

TEST(GridStudy, TakesOnePointMoreThanAPowerOfTwo) {
  auto uneven = small_grid_study();
  uneven.points = {16};
  EXPECT_THROW(run::run_all(*make_job(uneven, {1})), Failure);
}

}  // namespace
}  // namespace bezierbench::studies
