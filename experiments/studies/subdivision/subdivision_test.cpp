// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string_view>
#include <vector>

#include "experiments/studies/study_test.hpp"
#include "experiments/studies/subdivision/problem.hpp"

namespace bezierbench::studies {
namespace {

suite::Study small_subdivision_study() {
  auto study = small_study("subdivision");
  study.degree = {1, 5, 12};
  study.trials = 40;
  study.replicates = 2;
  return study;
}

suite::Study rational_study() {
  auto study = small_subdivision_study();
  study.form = Form::rational;
  study.generator = {"weights_wild"};
  return study;
}

TEST(SubdivisionStudy, BoundsAndPromisesHold) {
  for (const auto& study : {small_subdivision_study(), rational_study()}) {
    const auto csv = rows_of(study, "subdivision.csv");
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
  const auto csv = rows_of(study, "subdivision.csv");
  ASSERT_EQ(csv.row_count(), 5U);
  for (std::size_t row = 0; row < csv.row_count(); ++row) EXPECT_EQ(csv.at(row, "max_error"), "0");
}

/// Bounds are proved for t in [0,1] only.
TEST(SubdivisionStudy, HasNoBoundOutside) {
  auto study = small_subdivision_study();
  study.t_interval = {{-2, -1}};
  const auto csv = rows_of(study, "subdivision.csv");
  for (std::size_t row = 0; row < csv.row_count(); ++row) {
    EXPECT_EQ(csv.at(row, "bound_u"), "");
    EXPECT_EQ(csv.at(row, "bound_violations"), "");
    EXPECT_GT(run::number_at(csv, row, "max_error_u"), 0);
  }
}

const SplitKernel& kernel(std::string_view id, Form form, int dimension) {
  for (const auto& one : split_kernels(dimension))
    if (one.info->id == id && one.info->form == form) return one;
  throw std::invalid_argument("no such method");
}

SubdivisionErrors judge(const SplitKernel& method, const CurveView<double>& curve, double t) {
  SubdivisionProblem::Drawn drawn;
  drawn.trial.t = t;
  drawn.curve = curve;
  drawn.truth.emplace(curve, t);
  std::vector<double> halves;
  SubdivisionProblem::ask(method, drawn, 0, halves);
  SubdivisionErrors errors;
  SubdivisionProblem::judge(method, drawn, 0, halves, 7, errors);
  return errors;
}

const std::vector<double> line_points{1, 2, 5, -2};
const CurveView<double> line{Form::bernstein, 2, 1, line_points};
const std::vector<double> cubic_points{0.1, 0.7, -1.3, 2.9};
const CurveView<double> cubic{Form::bernstein, 1, 3, cubic_points};
const std::vector<double> weights{1, 0.3, 2.1, 0.7};
const CurveView<double> rational{Form::rational, 1, 3, cubic_points, weights};

/// The halves of the line from (1,2) to (5,-2) at 1/4 meet in (2,1).
void halves_of_the_line(const CurveView<double>& /*curve*/, double /*t*/, double* left, double* right) {
  const std::vector<double> numbers{1, 2, 2, 1, 2, 1, 5, -2};
  std::copy_n(numbers.begin(), 4, left);
  std::copy_n(numbers.begin() + 4, 4, right);
}

TEST(SplitJudge, KnowsTheHalvesOfALine) {
  SplitKernel method = kernel("de_casteljau_split", Form::bernstein, 2);
  method.split = halves_of_the_line;
  const auto right = judge(method, line, 0.25);
  EXPECT_EQ(right.error.count(), 4U);
  EXPECT_EQ(right.error.max(), 0);
  EXPECT_EQ(right.points_off.count + right.violations.count + right.broken_promises.count, 0U);
  EXPECT_EQ(right.middles, 1U);
  const auto wrong = judge(method, line, 0.5);  // these halves meet in (3,0), sqrt(2) away
  EXPECT_NEAR(wrong.error.max(), std::sqrt(2), 1e-6);
  EXPECT_EQ(wrong.violations.count, 1U);
  EXPECT_EQ(wrong.violations.first, 7U);
  EXPECT_EQ(wrong.points_off.count, 1U);
  EXPECT_EQ(wrong.broken_promises.count, 0U);
}

/// Moves the first number of the right half to the next double.
void apart(const CurveView<double>& curve, double t, double* left, double* right) {
  kernel("de_casteljau_split", curve.form, curve.dimension).split(curve, t, left, right);
  right[0] = std::nextafter(right[0], 10);
}

TEST(SplitJudge, CountsJunctionsThatAreNotShared) {
  SplitKernel method = kernel("de_casteljau_split", Form::bernstein, 1);
  method.split = apart;
  const auto promised = judge(method, cubic, 0.3);
  EXPECT_EQ(promised.junctions_apart.count, 1U);
  EXPECT_EQ(promised.broken_promises.count, 1U);
  EXPECT_EQ(promised.broken_promises.first, 7U);
  EXPECT_EQ(promised.ends_moved.count, 0U);
  EXPECT_EQ(promised.violations.count, 0U) << "within the bound";
  SplitPromises promises = *method.promises;
  promises.shares_junction = false;
  method.promises = &promises;
  const auto not_promised = judge(method, cubic, 0.3);
  EXPECT_EQ(not_promised.junctions_apart.count, 1U);
  EXPECT_EQ(not_promised.broken_promises.count, 0U);
}

/// Moves the weight of the last control point to the next double.
void end_moved(const CurveView<double>& curve, double t, double* left, double* right) {
  kernel("de_casteljau_split", curve.form, curve.dimension).split(curve, t, left, right);
  right[7] = std::nextafter(right[7], 10);
}

TEST(SplitJudge, CountsEndsThatMove) {
  SplitKernel method = kernel("de_casteljau_split", Form::rational, 1);
  EXPECT_EQ(judge(method, rational, 0.3).ends_moved.count, 0U);
  method.split = end_moved;
  const auto moved = judge(method, rational, 0.3);
  EXPECT_EQ(moved.ends_moved.count, 1U);
  EXPECT_EQ(moved.broken_promises.count, 1U);
  EXPECT_EQ(moved.junctions_apart.count, 0U);
}

TEST(SplitJudge, FindsABoundThatIsTooSmall) {
  for (const auto& curve : {cubic, rational}) {
    SplitKernel method = kernel("de_casteljau_split", curve.form, 1);
    EXPECT_EQ(judge(method, curve, 0.3).violations.count, 0U);
    SplitBound bound = *method.bound;
    bound.factor = [](int, double) { return 0.0; };
    bound.underflow = [](int) { return 0.0; };
    method.bound = &bound;
    const auto judged = judge(method, curve, 0.3);
    EXPECT_EQ(judged.violations.count, 1U) << name(curve.form);
    if (curve.form == Form::bernstein) {
      EXPECT_EQ(judged.points_off.count, 1U);
    }
  }
}

/// Doubles all weights of the halves: the points are the same, but the weights differ from those of the exact halves.
void heavier(const CurveView<double>& curve, double t, double* left, double* right) {
  kernel("de_casteljau_split", curve.form, curve.dimension).split(curve, t, left, right);
  for (int i = 0; i <= curve.degree; ++i) {
    left[2 * i + 1] *= 2;
    right[2 * i + 1] *= 2;
  }
}

TEST(SplitJudge, HoldsWeightsToTheirBound) {
  SplitKernel method = kernel("de_casteljau_split", Form::rational, 1);
  method.split = heavier;
  const auto judged = judge(method, rational, 0.3);
  EXPECT_EQ(judged.violations.count, 1U);
  EXPECT_EQ(judged.points_off.count, 0U) << "a common factor changes no point";
  EXPECT_NEAR(judged.weight_error_u.value * 0x1p-53, 1, 1e-6);
}

void not_finite(const CurveView<double>& curve, double t, double* left, double* right) {
  kernel("de_casteljau_split", curve.form, curve.dimension).split(curve, t, left, right);
  left[1] = std::nan("");
}

TEST(SplitJudge, CountsNumbersThatAreNotFinite) {
  SplitKernel method = kernel("de_casteljau_split", Form::bernstein, 1);
  method.split = not_finite;
  const auto judged = judge(method, cubic, 0.3);
  EXPECT_EQ(judged.non_finite, 1U);
  EXPECT_EQ(judged.error.count(), 0U);
}

TEST(SplitJudge, ProvesNothingWithWeightsOfBothSigns) {
  const std::vector<double> both{1, -0.1, 1, 1};
  const auto& method = kernel("de_casteljau_split", Form::rational, 1);
  const auto judged = judge(method, {Form::rational, 1, 3, cubic_points, both}, 0.3);
  EXPECT_EQ(judged.bounded, 0U);
  EXPECT_EQ(judged.error.count(), 8U);
}

/// The weight of the junction is 1 - 4t, which is 0 here.
TEST(SplitJudge, FindsNoPointWhereItsWeightIsZero) {
  const std::vector<double> points{1, 2};
  const std::vector<double> signs{1, -3};
  const SplitTruth truth({Form::rational, 1, 1, points, signs}, 0.25);
  const auto junction = truth.point_error(nullptr, Side::left, 1, std::vector{1.0});
  EXPECT_EQ(junction.error, std::numeric_limits<double>::infinity());
  EXPECT_EQ(truth.weight_error(nullptr, Side::left, 1, 0).error, 0);
  EXPECT_EQ(truth.point_error(nullptr, Side::left, 0, std::vector{1.0}).error, 0);
}

/// The bounds use norms of vectors. Each axis has its largest coefficient in another control point.
TEST(SplitJudge, BoundsOfLargestCoefficientsCoverAllAxes) {
  const std::vector<double> points{1, 0, 0, 1};
  const CurveView<double> curve{Form::bernstein, 2, 1, points};
  const SplitTruth truth(curve, 0.5);
  const auto& method = kernel("lerp_split", Form::bernstein, 2);
  const double bound = truth.point_error(method.bound, Side::left, 1, std::vector{0.5, 0.5}).bound;
  EXPECT_NEAR(bound, 5 * 0x1p-53 * std::sqrt(2), 1e-20);
}

}  // namespace
}  // namespace bezierbench::studies
