// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include "experiments/failure.hpp"
#include "experiments/run/job_test.hpp"
#include "experiments/sample/data_kind.hpp"
#include "experiments/studies/roster.hpp"

namespace bezierbench::studies {
namespace {

suite::Study small_fitting_study() {
  suite::Study study;
  study.id = "small";
  study.kind = &kind("fitting");
  study.points = {3, 12};
  study.tolerance = {1e-2, 1e-9};
  study.degree = {3};
  study.generator = {"integer"};  // gives equal distances, turns and coinciding points
  study.trials = 60;              // two blocks, the last one short
  return study;
}

TEST(FittingStudy, OrderAndInterruptionsChangeNoByteAndPromisesAreKept) {
  const auto files = run::expect_order_changes_nothing(make_job, small_fitting_study());
  const auto csv = bundle::parse_csv(files.at("fitting.csv"), "fitting.csv");
  ASSERT_EQ(csv.row_count(), 2 * sample::data_kinds().size() * 2 * 2);
  EXPECT_EQ(make_job(small_fitting_study(), {1})->extent().rows, csv.row_count());
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
  study.kind = &kind("fitting");
  study.points = {12};
  study.tolerance = {1e-9};
  const auto job = make_job(study, {1});
  run::run_all(*job);
  const auto csv = bundle::parse_csv(run::text_of(*job).at("fitting.csv"), "fitting.csv");
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
  const auto job = make_job(study, {1});
  run::run_all(*job);
  const auto csv = bundle::parse_csv(run::text_of(*job).at("fitting_example.csv"), "fitting_example.csv");
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

TEST(FittingStudy, RefusesWhatItCannotDo) {
  auto polynomial = small_fitting_study();
  polynomial.form = Form::power;
  EXPECT_THROW(make_job(polynomial, {1}), Failure);
  auto single = small_fitting_study();
  single.scalar = {suite::ScalarKind::float32};
  EXPECT_THROW(make_job(single, {1}), Failure);
  auto point = small_fitting_study();
  point.degree = {0};
  EXPECT_THROW(make_job(point, {1}), Failure);
  auto roots = small_fitting_study();
  roots.generator = {"multiple_root"};
  EXPECT_THROW(make_job(roots, {1}), Failure);
  auto evaluator = small_fitting_study();
  evaluator.methods = {"de_casteljau"};
  EXPECT_THROW(make_job(evaluator, {1}), Failure);
}

}  // namespace
}  // namespace bezierbench::studies
