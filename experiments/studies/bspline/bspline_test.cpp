// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include "experiments/sample/knot_kind.hpp"
#include "experiments/studies/study_test.hpp"

namespace bezierbench::studies {
namespace {

suite::Study small_bspline_study() {
  auto study = small_study("bspline");
  study.degree = {1, 3, 6};
  study.trials = 40;
  return study;
}

bool makes_bernstein(const bundle::CsvDocument& csv, std::size_t row) {
  return csv.at(row, "method").ends_with("_span");
}

void expect_bounds_hold(const suite::Study& study) {
  const auto csv = rows_of(study, "bspline.csv");
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

TEST(BsplineStudy, BoundsHoldOverEveryKindOfKnots) { expect_bounds_hold(small_bspline_study()); }

TEST(BsplineStudy, BoundsHoldWithWeights) {
  for (const std::string generator : {"weights_mild", "weights_wild"}) {
    auto study = small_bspline_study();
    study.form = Form::rational;
    study.generator = {generator};
    expect_bounds_hold(study);
  }
}

/// Over a clamped span the curve begins in its first control point, which no step changes.
TEST(BsplineStudy, IsExactAtTheFirstPointOfAClampedCurve) {
  auto study = small_bspline_study();
  study.t_interval = {{0, 0}};
  const auto csv = rows_of(study, "bspline.csv");
  int clamped = 0;
  for (std::size_t row = 0; row < csv.row_count(); ++row) {
    if (csv.at(row, "knots") != "clamped") continue;
    EXPECT_EQ(csv.at(row, "max_error"), "0") << csv.at(row, "method");
    ++clamped;
  }
  EXPECT_EQ(clamped, 3 * 4);
}

}  // namespace
}  // namespace bezierbench::studies
