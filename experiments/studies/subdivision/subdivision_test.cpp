// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include "experiments/failure.hpp"
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
  study.form = Form::rational;
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
      EXPECT_EQ(csv.at(row, "max_weight_error_u").empty(), study.form == Form::bernstein);
    }
  }
}

/// The halves at t = 1/2 of a line between integer points have coordinates that are multiples of 1/2.
TEST(SubdivisionStudy, IsExactWhereNothingIsRounded) {
  auto study = small_subdivision_study();
  study.degree = {1};
  study.coordinate_range = {1000};
  study.generator = {"integer"};
  study.t_interval = {{0.5, 0.5}};
  const auto csv = subdivision_rows_of(study);
  ASSERT_EQ(csv.row_count(), 5U);
  for (std::size_t row = 0; row < csv.row_count(); ++row) EXPECT_EQ(csv.at(row, "max_error"), "0");
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

TEST(SubdivisionStudy, RefusesWhatItCannotDo) {
  auto power = small_subdivision_study();
  power.form = Form::power;
  EXPECT_THROW(make_job(power, {1}), Failure);
  auto single = small_subdivision_study();
  single.scalar = {suite::ScalarKind::float32};
  EXPECT_THROW(make_job(single, {1}), Failure);
  auto of_points = small_subdivision_study();
  of_points.methods = {"de_casteljau"};
  EXPECT_THROW(make_job(of_points, {1}), Failure);
}

}  // namespace
}  // namespace bezierbench::studies
