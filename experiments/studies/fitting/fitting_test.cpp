// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include "experiments/sample/data_kind.hpp"
#include "experiments/studies/study_test.hpp"

namespace bezierbench::studies {
namespace {

suite::Study small_fitting_study() {
  auto study = small_study("fitting");
  study.points = {3, 12};
  study.tolerance = {1e-2, 1e-9};
  study.degree = {3};
  study.generator = {"integer"};  // gives equal distances, turns and coinciding points
  study.trials = 60;
  return study;
}

TEST(FittingStudy, PromisesAreKept) {
  const auto csv = rows_of(small_fitting_study(), "fitting.csv");
  ASSERT_EQ(csv.row_count(), 2 * sample::data_kinds().size() * 2 * 2);
  for (std::size_t row = 0; row < csv.row_count(); ++row) {
    for (const char* column : {"broken_promises", "understated", "non_converged", "non_finite"})
      EXPECT_EQ(csv.at(row, column), "0") << row << " " << column;
    EXPECT_LE(run::number_at(csv, row, "max_error"), run::number_at(csv, row, "max_claimed") * (1 + 0x1p-23)) << row;
    EXPECT_LE(run::number_at(csv, row, "max_error_over_tolerance"), 1) << row;
    EXPECT_GE(run::number_at(csv, row, "mean_segments"), 1) << row;
    EXPECT_LE(run::number_at(csv, row, "max_segments"), run::number_at(csv, row, "points") - 1) << row;
  }
}

TEST(FittingStudy, SaysWhatGivesItsSourceBack) {
  auto study = small_fitting_study();
  study.generator = {"continuous"};
  study.points = {12};
  study.tolerance = {1e-9};
  const auto csv = rows_of(study, "fitting.csv");
  ASSERT_EQ(csv.at(0, "data"), "samples");
  ASSERT_EQ(csv.at(0, "method"), "schneider");
  EXPECT_EQ(csv.at(0, "one_segment"), "0");
  EXPECT_GT(run::number_at(csv, 1, "one_segment"), 20);
}

/// The example has the data, then each method's fit, which goes from the first data point to the last.
TEST(FittingStudy, ShowsAnExample) {
  auto study = small_fitting_study();
  study.points = {12};
  study.trials = 1;
  const auto csv = rows_of(study, "fitting_example.csv");
  std::size_t row = 0;
  for (const auto& kind : sample::data_kinds()) {
    const std::size_t data = row;
    for (; csv.at(row, "method").empty(); ++row) {
      EXPECT_EQ(csv.at(row, "data"), kind.id);
      EXPECT_EQ(csv.at(row, "segment"), "");
    }
    EXPECT_EQ(row - data, 12U);
    for (const char* method : {"schneider", "gauss_newton"}) {
      EXPECT_EQ(csv.at(row, "x"), csv.at(data, "x")) << kind.id;
      for (; row < csv.row_count() && csv.at(row, "method") == method; ++row) EXPECT_EQ(csv.at(row, "data"), kind.id);
      EXPECT_EQ(csv.at(row - 1, "index"), "3");
      EXPECT_EQ(csv.at(row - 1, "y"), csv.at(data + 11, "y")) << kind.id;
    }
  }
  EXPECT_EQ(row, csv.row_count());
}

}  // namespace
}  // namespace bezierbench::studies
