// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/evaluate/kernel/prepared_state.hpp"
#include "experiments/studies/exhaustive/float_tally.hpp"
#include "experiments/studies/study_test.hpp"
#include "reference/exact_curve.hpp"

namespace bezierbench::studies {
namespace {

/// A few thousand floats around 1/2, so that integers can judge them all.
const suite::Interval few{0x1.ffap-2, 0x1.001p-1};

FloatCurve curve_of(const suite::Study& study, std::string_view id) {
  const auto& set = *study.sets.front();
  return {set.id, id, set.curves[set.curves.find(id)]};
}

suite::Study small_exhaustive_study() {
  auto study = small_study("exhaustive");
  take_named(study, {"glyph_tail", "wilkinson_3"});
  study.methods = {"de_casteljau", "de_casteljau_lerp", "differences:horner", "correctly_rounded"};
  study.t_interval = {few};
  return study;
}

/// What the row of a method says, found in integers by the definitions of its columns.
FloatTally by_definition(const FloatCurve& curve, const Kernel<float>& kernel, const FloatRange& range) {
  FloatTally tally;
  reference::ExactCurve exact;
  std::vector<float> before;
  for (std::uint32_t bits = range.first; bits <= range.last; ++bits) {
    const float t = float_of(bits);
    std::vector<float> point(static_cast<std::size_t>(curve.dimension));
    PreparedState<float>(kernel, curve.view()).evaluate({&t, 1}, point.data());
    bool misrounded = false;
    bool outside = false;
    bool back = false;
    for (int axis = 0; axis < curve.dimension; ++axis) {
      const auto coordinates = curve.axis(axis);
      const std::vector<double> coefficients(coordinates.begin(), coordinates.end());
      const auto a = static_cast<std::size_t>(axis);
      const auto truth = exact.point({Form::bernstein, 1, curve.degree(), coefficients}, t).coordinate(0);
      const double computed = point[a];
      const auto error = reference::abs(reference::exactly(computed) - truth);
      const double ulp = std::ldexp(
          1.0, truth.numerator == 0 ? -149 : static_cast<int>(std::max(reference::floor_log2(truth) - 23, -149L)));
      const double in_ulp = reference::round_to(reference::error_format, error) / ulp;
      if (in_ulp > tally.max_error) {
        tally.max_error = in_ulp;
        tally.worst_t = bits;
      }
      misrounded = misrounded || reference::round_to(reference::binary32, truth) != computed;
      outside = outside || point[a] < *std::ranges::min_element(coordinates) ||
                point[a] > *std::ranges::max_element(coordinates);
      if (before.empty()) continue;
      back = back || (std::ranges::is_sorted(coordinates) && point[a] < before[a]) ||
             (std::ranges::is_sorted(coordinates, std::greater()) && point[a] > before[a]);
    }
    tally.misrounded += misrounded ? 1 : 0;
    tally.out_of_hull += outside ? 1 : 0;
    tally.non_monotone += back ? 1 : 0;
    before = point;
  }
  return tally;
}

TEST(Exhaustive, RowsAreWhatTheIntegersSay) {
  const auto study = small_exhaustive_study();
  const auto table = rows_of(study, "exhaustive.csv");
  const auto range = floats_in(few);
  ASSERT_TRUE(range);
  ASSERT_EQ(table.row_count(), 8U);
  for (std::size_t row = 0; row < table.row_count(); ++row) {
    const auto curve = curve_of(study, table.at(row, "curve_id"));
    const auto* kernel = find_kernel<float>(table.at(row, "method"), Form::bernstein, curve.dimension);
    ASSERT_NE(kernel, nullptr);
    const FloatTally expected = by_definition(curve, *kernel, *range);
    const auto what = curve.id + " " + table.at(row, "method");
    EXPECT_EQ(run::number_at(table, row, "max_error_ulp"), expected.max_error) << what;
    EXPECT_EQ(run::number_at(table, row, "worst_t"), double{float_of(expected.worst_t)}) << what;
    EXPECT_EQ(run::number_at(table, row, "misrounded"), static_cast<double>(expected.misrounded)) << what;
    EXPECT_EQ(run::number_at(table, row, "out_of_hull"), static_cast<double>(expected.out_of_hull)) << what;
    EXPECT_EQ(run::number_at(table, row, "points"), static_cast<double>(range->count()));
    if (curve.id == "wilkinson_3")
      EXPECT_EQ(table.at(row, "non_monotone"), "");
    else
      EXPECT_EQ(run::number_at(table, row, "non_monotone"), static_cast<double>(expected.non_monotone)) << what;
    if (kernel->info->id == "correctly_rounded")
      EXPECT_EQ(run::number_at(table, row, "misrounded"), 0) << what;
    else
      EXPECT_GT(run::number_at(table, row, "misrounded"), 0) << what;
  }
}

/// More than one block, the last shorter: the steps between blocks count, and every point once.
TEST(Exhaustive, BlocksChangeNothing) {
  auto study = small_exhaustive_study();
  take_named(study, {"hermite_value_1"});
  study.methods = {"horner_bernstein"};
  study.t_interval = {{0x1p-2, 0x1.8p-1}};
  const auto job = make_job(study, {1});
  ASSERT_GT(job->blocks_per_part(), 1U);
  const auto whole = rows_of(study, "exhaustive.csv");
  study.t_interval = {{0x1p-2, 0x1.fffffep-2}, {0x1p-1, 0x1.8p-1}};
  const auto halves = rows_of(study, "exhaustive.csv");
  ASSERT_EQ(halves.row_count(), 2U);
  for (const auto* column : {"points", "misrounded", "out_of_hull"})
    EXPECT_EQ(run::number_at(whole, 0, column), run::number_at(halves, 0, column) + run::number_at(halves, 1, column));
  EXPECT_GE(run::number_at(whole, 0, "non_monotone"),
            run::number_at(halves, 0, "non_monotone") + run::number_at(halves, 1, "non_monotone"));
  EXPECT_EQ(run::number_at(whole, 0, "max_error_ulp"),
            std::max(run::number_at(halves, 0, "max_error_ulp"), run::number_at(halves, 1, "max_error_ulp")));
}

TEST(Exhaustive, RefusesSetsWithoutBezierCurvesAndEmptyIntervals) {
  auto study = small_exhaustive_study();
  take_named(study, {});
  EXPECT_THROW(make_job(study, {1}), Failure);
  take_named(study, {"css_ease"});
  study.t_interval = {{0.1, 0.1}};
  EXPECT_THROW(make_job(study, {1}), Failure);
}

TEST(FloatRange, HasTheFloatsOfTheInterval) {
  const auto whole = floats_in({0, 1});
  ASSERT_TRUE(whole);
  EXPECT_EQ(whole->count(), 1065353217U);
  EXPECT_EQ(floats_in({-0.0, 0})->count(), 1U);
  EXPECT_EQ(floats_in({0.25, 1})->count(), (1U << 24U) + 1);
  const auto inside = floats_in({0.1, 0.3});  // neither is a float
  EXPECT_GT(double{float_of(inside->first)}, 0.1);
  EXPECT_LT(double{float_of(inside->first - 1)}, 0.1);
  EXPECT_LT(double{float_of(inside->last)}, 0.3);
  EXPECT_GT(double{float_of(inside->last + 1)}, 0.3);
}

TEST(FloatJudge, CountsNumbersThatAreNotFinite) {
  reference::FloatValues truth{};
  truth.scale.fill(0x1p11F);
  truth.scale_too.fill(0x1p12F);
  truth.nearest.fill(1);
  const std::vector<float> control{0, 1};
  const std::vector<float> values{1, std::numeric_limits<float>::quiet_NaN(), 1, -0x1p+127F, 1};
  FloatJudge judge;
  FloatTally tally;
  judge.begin(values.size());
  judge.add_axis(AxisLimits(control), truth, values.data(), nullptr);
  judge.end(100, tally);
  EXPECT_EQ(tally.misrounded, 2U);
  EXPECT_EQ(tally.out_of_hull, 2U);
  EXPECT_EQ(tally.non_monotone, 1U);
  EXPECT_EQ(tally.max_error, std::numeric_limits<double>::infinity());
  EXPECT_EQ(tally.worst_t, 101U);
  FloatTally finite;
  judge.begin(1);
  judge.add_axis(AxisLimits(control), truth, values.data() + 3, nullptr);
  judge.end(7, finite);
  EXPECT_EQ(finite.max_error, (0x1p127 + 1) * 0x1p23);  // above the largest float
  EXPECT_EQ(finite.worst_t, 7U);
}

}  // namespace
}  // namespace bezierbench::studies
