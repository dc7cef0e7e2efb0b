// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include "experiments/failure.hpp"
#include "experiments/run/job_test.hpp"
#include "experiments/sample/knot_kind.hpp"
#include "experiments/studies/roster.hpp"

namespace bezierbench::studies {
namespace {

suite::Study small_bspline_study() {
  suite::Study study;
  study.id = "small";
  study.kind = &kind("bspline");
  study.degree = {1, 3, 6};
  study.trials = 40;  // two blocks, the last one short
  return study;
}

bundle::CsvDocument bspline_rows_of(const suite::Study& study) {
  const auto job = make_job(study, {1});
  run::run_all(*job);
  EXPECT_TRUE(job->violations().empty());
  return bundle::parse_csv(run::text_of(*job).at("bspline.csv"), "bspline.csv");
}

bool makes_bernstein(const bundle::CsvDocument& csv, std::size_t row) {
  return csv.at(row, "method").ends_with("_span");
}

TEST(BsplineStudy, OrderAndInterruptionsChangeNoByte) {
  const auto files = run::expect_order_changes_nothing(make_job, small_bspline_study());
  EXPECT_EQ(make_job(small_bspline_study(), {1})->extent().rows,
            bundle::parse_csv(files.at("bspline.csv"), "bspline.csv").row_count());
}

TEST(BsplineStudy, BoundsHoldOverEveryKindOfKnots) {
  const auto csv = bspline_rows_of(small_bspline_study());
  ASSERT_EQ(csv.row_count(), 3 * sample::knot_kinds().size() * 4);
  for (std::size_t row = 0; row < csv.row_count(); ++row) {
    const auto where = csv.at(row, "method") + " " + csv.at(row, "knots") + " " + csv.at(row, "degree");
    EXPECT_EQ(csv.at(row, "non_finite"), "0") << where;
    EXPECT_GT(run::number_at(csv, row, "max_error_u"), 0) << where;
    EXPECT_EQ(csv.at(row, "max_control_error_u").empty(), !makes_bernstein(csv, row)) << where;
    const bool proved = csv.at(row, "method") != "chudy_wozny_span";
    EXPECT_EQ(csv.at(row, "bound_violations"), proved ? "0" : "") << where;
    if (!proved) continue;
    EXPECT_LE(run::number_at(csv, row, "max_error_u"), run::number_at(csv, row, "bound_u")) << where;
    if (!makes_bernstein(csv, row)) continue;
    EXPECT_LE(run::number_at(csv, row, "max_control_error_u"), run::number_at(csv, row, "control_bound_u")) << where;
  }
}

/// Over a clamped span the curve begins in its first control point, which no step changes.
TEST(BsplineStudy, IsExactAtTheFirstPointOfAClampedCurve) {
  auto study = small_bspline_study();
  study.t_interval = {{0, 0}};
  const auto csv = bspline_rows_of(study);
  int clamped = 0;
  for (std::size_t row = 0; row < csv.row_count(); ++row) {
    if (csv.at(row, "knots") != "clamped") continue;
    EXPECT_EQ(csv.at(row, "max_error"), "0") << csv.at(row, "method");
    ++clamped;
  }
  EXPECT_EQ(clamped, 3 * 4);
}

TEST(BsplineStudy, RefusesWhatItCannotDo) {
  auto rational = small_bspline_study();
  rational.form = Form::rational;
  EXPECT_THROW(make_job(rational, {1}), Failure);
  auto single = small_bspline_study();
  single.scalar = {suite::ScalarKind::float32};
  EXPECT_THROW(make_job(single, {1}), Failure);
  auto constant = small_bspline_study();
  constant.degree = {0};
  EXPECT_THROW(make_job(constant, {1}), Failure);
  auto outside = small_bspline_study();
  outside.t_interval = {{0, 1.5}};
  EXPECT_THROW(make_job(outside, {1}), Failure);
  auto whole = small_bspline_study();
  whole.generator = {"bspline"};
  EXPECT_THROW(make_job(whole, {1}), Failure);
}

}  // namespace
}  // namespace bezierbench::studies
