// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include "experiments/run/job_test.hpp"
#include "experiments/studies/roster.hpp"

namespace bezierbench::studies {
namespace {

suite::Study small_subdivision_study() {
  suite::Study study;
  study.id = "small";
  study.kind = &kind("subdivision");
  study.degree = {1, 5, 12};
  study.trials = 40;  // two blocks, the last one short
  study.replicates = 2;
  return study;
}

suite::Study rational_study() {
  auto study = small_subdivision_study();
  study.curve = Form::rational;
  study.generator = {"weights_wild"};
  return study;
}

bundle::CsvDocument subdivision_rows_of(const suite::Study& study) {
  const auto job = make_job(study, {1});
  run::run_all(*job);
  EXPECT_TRUE(job->violations().empty());
  return bundle::parse_csv(run::text_of(*job).at("subdivision.csv"), "subdivision.csv");
}

TEST(SubdivisionStudy, OrderAndInterruptionsChangeNoByte) {
  for (const auto& study : {small_subdivision_study(), rational_study()}) {
    const auto files = run::expect_order_changes_nothing(make_job, study);
    EXPECT_EQ(make_job(study, {1})->extent().rows,
              bundle::parse_csv(files.at("subdivision.csv"), "subdivision.csv").row_count());
  }
}

TEST(SubdivisionStudy, BoundsAndPromisesHold) {
  for (const auto& study : {small_subdivision_study(), rational_study()}) {
    const auto csv = subdivision_rows_of(study);
    ASSERT_EQ(csv.row_count(), 3U * 5);
    for (std::size_t row = 0; row < csv.row_count(); ++row) {
      EXPECT_EQ(csv.at(row, "trials"), "80");
      EXPECT_EQ(csv.at(row, "status"), "ok");
      for (const auto* column : {"bound_violations", "junctions_apart", "ends_moved", "non_finite"})
        EXPECT_EQ(csv.at(row, column), "0") << csv.at(row, "method") << " " << column;
      EXPECT_EQ(csv.at(row, "points_off"), csv.at(row, "method") == "lerp_split" ? "" : "0") << csv.at(row, "method");
      EXPECT_GT(run::number_at(csv, row, "max_error_u"), 0);
      EXPECT_LE(run::number_at(csv, row, "mean_error_u"), run::number_at(csv, row, "max_error_u"));
      EXPECT_EQ(csv.at(row, "max_weight_error_u").empty(), study.curve == Form::bernstein);
    }
  }
}

/// Bounds are proved for t in [0,1] only.
TEST(SubdivisionStudy, HasNoBoundOutside) {
  auto study = small_subdivision_study();
  study.t_interval = {{-2, -1}};
  const auto csv = subdivision_rows_of(study);
  for (std::size_t row = 0; row < csv.row_count(); ++row) {
    EXPECT_EQ(csv.at(row, "bound_u"), "");
    EXPECT_EQ(csv.at(row, "bound_violations"), "");
    EXPECT_GT(run::number_at(csv, row, "max_error_u"), 0);
  }
}

}  // namespace
}  // namespace bezierbench::studies
