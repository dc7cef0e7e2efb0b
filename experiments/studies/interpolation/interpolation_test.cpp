// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include "core/interpolate/kernel.hpp"
#include "experiments/studies/interpolation/problem.hpp"
#include "experiments/studies/study_test.hpp"

namespace bezierbench::studies {
namespace {

suite::Study interpolation_study_of(std::vector<std::string> methods) {
  auto study = small_study("interpolation", std::move(methods));
  study.points = {2, 12};
  study.dimension = {1, 3};
  study.trials = 40;
  return study;
}

TEST(InterpolationStudy, HasARowForEachNumberOfPoints) {
  const auto csv = rows_of(interpolation_study_of({"c2_natural"}), "interpolation.csv");
  ASSERT_EQ(csv.row_count(), 4U);
  for (std::size_t row = 0; row < 4; ++row) {
    EXPECT_EQ(csv.at(row, "points"), row % 2 == 0 ? "2" : "12");
    EXPECT_EQ(csv.at(row, "degree"), "3");
    EXPECT_EQ(csv.at(row, "trials"), "40");
    EXPECT_EQ(csv.at(row, "bound_violations"), "0");
    EXPECT_EQ(csv.at(row, "max_data_u"), "0");
    EXPECT_EQ(csv.at(row, "max_c2_u") == "0", row % 2 == 0) << "a single segment has no knot";
    EXPECT_LE(run::number_at(csv, row, "max_c2_u"), 8) << row;
    EXPECT_LE(run::number_at(csv, row, "max_error_u"), 1.74) << row;
    EXPECT_GT(run::number_at(csv, row, "max_error_u"), 0.1) << row;
  }
}

TEST(InterpolationStudy, TellsMethodsApart) {
  const auto csv = rows_of(interpolation_study_of({}), "interpolation.csv");
  ASSERT_EQ(csv.row_count(), 12U);
  EXPECT_EQ(csv.at(3, "method"), "c2_natural");
  EXPECT_EQ(csv.at(4, "method"), "c2_natural_handles");
  EXPECT_EQ(csv.at(5, "method"), "seed_003");
  EXPECT_LT(run::number_at(csv, 3, "mean_c2_u"), run::number_at(csv, 4, "mean_c2_u"));
  EXPECT_EQ(csv.at(4, "bound_violations"), "");
  EXPECT_GT(run::number_at(csv, 5, "mean_c1_u"), 0x1p+40) << "kinks of the size of the points";
  EXPECT_EQ(csv.at(5, "bound_violations"), "");
}

/// There the bound is hardly more than its underflow term, which residuals attain in part, and is printed with it.
TEST(InterpolationStudy, BoundsResidualsOfSubnormalPoints) {
  auto study = interpolation_study_of({"c2_natural"});
  study.coordinate_range = {1e-320};
  const auto csv = rows_of(study, "interpolation.csv");
  for (std::size_t row = 0; row < csv.row_count(); ++row) {
    EXPECT_EQ(csv.at(row, "bound_violations"), "0");
    EXPECT_LE(run::number_at(csv, row, "max_c2_u"), run::number_at(csv, row, "bound_u"));
    EXPECT_GT(run::number_at(csv, row, "bound_u"), 1e10);
  }
  study.coordinate_range = {1};
  EXPECT_EQ(rows_of(study, "interpolation.csv").at(0, "bound_u"), "7.1");
}

TEST(InterpolationStudy, LeavesOutTheErrorWhereThereAreTooManyPoints) {
  auto study = interpolation_study_of({"c2_natural"});
  study.points = {max_exact_spline_points, max_exact_spline_points + 1};
  study.dimension = {1};
  study.trials = 1;
  const auto csv = rows_of(study, "interpolation.csv");
  EXPECT_NE(csv.at(0, "max_error_u"), "");
  EXPECT_EQ(csv.at(1, "max_error_u"), "");
  EXPECT_GT(run::number_at(csv, 1, "max_c2_u"), 0);
}

/// 0, 3, 6 are joined by straight segments. Moving one control point by 1/4 gives errors in units of u times 6.
TEST(SplineJudge, MeasuresWhatIsWrong) {
  const std::vector<double> points{0, 3, 6};
  std::vector<double> segments{0, 1, 2, 3, 3, 4, 5, 6};
  const SplineJudge judge(points, 1, true);
  SplineErrors errors;
  judge.judge(segments, 8, 0, errors);
  EXPECT_EQ(errors.violations.count, 0U);
  segments[2] += 0.25;
  const double unit = 6 * 0x1p-53;
  judge.judge(segments, 0.249 / unit, 7, errors);
  EXPECT_EQ(errors.violations.count, 1U);
  EXPECT_EQ(errors.violations.first, 7U);
  EXPECT_EQ(errors.error.max(), 0.25);
  const auto quarters = [unit](const metric::Tally& tally) { return tally.max() * unit * 4; };
  EXPECT_NEAR(quarters(errors.error_u), 1, 1e-6);
  EXPECT_NEAR(quarters(errors.c1), 1, 1e-6);
  EXPECT_NEAR(quarters(errors.c2), 2, 1e-6);
  EXPECT_NEAR(quarters(errors.natural), 1, 1e-6);
  EXPECT_EQ(errors.c0.max() + errors.data.max(), 0);
  segments[2] = 1 / 0.0;
  judge.judge(segments, 8, 8, errors);
  EXPECT_EQ(errors.non_finite, 1U);
  EXPECT_EQ(errors.c1.count(), 2U);
}

/// The same, smaller by 2^-1060: a subnormal error is kept as it is.
TEST(SplineJudge, MeasuresSubnormalErrors) {
  constexpr double tiny = 0x1p-1060;
  const std::vector<double> points{0, 3 * tiny, 6 * tiny};
  const std::vector<double> segments{0, tiny, 2.25 * tiny, 3 * tiny, 3 * tiny, 4 * tiny, 5 * tiny, 6 * tiny};
  SplineErrors errors;
  SplineJudge(points, 1, true).judge(segments, 0, 0, errors);
  EXPECT_EQ(errors.error.max(), 0.25 * tiny);
}

}  // namespace
}  // namespace bezierbench::studies
