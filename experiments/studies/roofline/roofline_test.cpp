// SPDX-License-Identifier: MIT
// What is made of the times of a roofline; the times are made up, so that no clock decides.
#include "experiments/studies/roofline/roofline.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <string>
#include <vector>

#include "experiments/bundle/csv.hpp"
#include "experiments/studies/roster.hpp"
#include "reference/number/number.hpp"

namespace bezierbench::studies {
namespace {

suite::Study roofline_study() {
  suite::Study study;
  study.id = "s";
  study.kind = &kind("roofline");
  study.degree = {20};
  study.methods = {"de_casteljau", "de_casteljau_lerp_fma", "horner_bernstein_fma", "exact_dd:horner_dd"};
  study.goals = {{.method = "horner_bernstein_fma", .share = 0.6},
                 {.method = "de_casteljau_lerp_fma", .share = 1, .needs_additions_beside = true}};
  return study;
}

race::RoundTimes round_times(double ns) {
  race::RoundTimes lap;
  lap.ns_per_point.assign(10, ns);
  return lap;
}

/// What every rival took; a peak of 10 GFLOP/s, and 12 with additions beside.
using Times = double (*)(const TargetRival& who);
double all_alike(const TargetRival& who) {
  switch (who.work) {
    case Work::batch_points: return 20;
    case Work::multiply_add: return 1.0 / 10;
    case Work::multiply_add_and_add: break;
  }
  return 1.0 / 12;
}

bundle::CsvDocument written(const suite::Study& study, Times times = all_alike) {
  auto races = roofline_races_of(study);
  for (auto& race : races)
    for (const auto& who : race.rivals) race.times.push_back(round_times(times(who)));
  tables::Tables tables;
  write_roofline_rows(study, races, tables);
  return bundle::parse_csv(tables.all().at("roofline.csv").text(), "roofline.csv");
}

/// The different fields of a method's rows in a column.
std::set<std::string> values(const bundle::CsvDocument& document, std::string_view method, std::string_view column) {
  std::set<std::string> found;
  for (std::size_t row = 0; row < document.row_count(); ++row)
    if (document.at(row, "method") == method) found.insert(document.at(row, column));
  return found;
}

class Roofline : public testing::Test {
 protected:
  void SetUp() override {
    if (batch::usable_targets().empty()) GTEST_SKIP() << "this processor has no target";
  }
};

TEST_F(Roofline, EveryTargetRunsEveryMethodThatHasABatchKernel) {
  auto study = roofline_study();
  study.methods = {"de_casteljau", "direct_pow"};
  const auto races = roofline_races_of(study);
  ASSERT_EQ(races.size(), 1U);
  EXPECT_EQ(races[0].rivals.size(), 3 * batch::usable_targets().size()) << "two peaks and a kernel of each target";
  for (const auto& who : races[0].rivals)
    EXPECT_TRUE(who.method == nullptr || who.method->id == "de_casteljau") << who.method->id;
}

TEST_F(Roofline, IsNoRaceWhereNoMethodSupportsTheDegree) {
  auto study = roofline_study();
  study.methods = {"horner_bernstein_fma"};
  study.degree = {200};
  study.scalar = {suite::ScalarKind::float32};
  EXPECT_TRUE(roofline_races_of(study)[0].rivals.empty());
  EXPECT_EQ(written(study).row_count(), 0U);
}

TEST_F(Roofline, AShareIsOfThePeakOfItsTarget) {
  const auto table = written(roofline_study());
  EXPECT_THAT(values(table, "horner_bernstein_fma", "flops"), testing::ElementsAre("141"));  // n(1+3d) + 1
  EXPECT_THAT(values(table, "horner_bernstein_fma", "gflops"), testing::ElementsAre("7.05"));
  EXPECT_THAT(values(table, "horner_bernstein_fma", "peak_gflops"), testing::ElementsAre("10"));
  EXPECT_THAT(values(table, "horner_bernstein_fma", "mixed_peak_gflops"), testing::ElementsAre("12"));
  for (const auto& share : values(table, "horner_bernstein_fma", "share_of_peak"))
    EXPECT_NEAR(std::stod(share), 0.705, 1e-12);
}

TEST_F(Roofline, GoalsAreMetOrNot) {
  const auto table = written(roofline_study());
  EXPECT_THAT(values(table, "horner_bernstein_fma", "goal_share"), testing::ElementsAre("0.6"));
  EXPECT_THAT(values(table, "horner_bernstein_fma", "goal_met"), testing::ElementsAre("yes"));
  EXPECT_THAT(values(table, "de_casteljau_lerp_fma", "goal_met"), testing::ElementsAre("yes")) << "1260 flops in 20 ns";
  EXPECT_THAT(values(table, "de_casteljau", "goal_met"), testing::ElementsAre("")) << "it has no goal";
  const auto slower = written(
      roofline_study(), [](const TargetRival& who) { return who.work == Work::batch_points ? 200.0 : all_alike(who); });
  for (const auto* id : {"horner_bernstein_fma", "de_casteljau_lerp_fma"})
    EXPECT_THAT(values(slower, id, "goal_met"), testing::ElementsAre("no")) << id;
}

TEST_F(Roofline, GoalsAreThoseOfTheStudy) {
  auto study = roofline_study();
  study.goals = {};
  for (const auto& id : study.methods) {
    EXPECT_THAT(values(written(study), id, "goal_met"), testing::ElementsAre("")) << id;
    EXPECT_THAT(values(written(study), id, "goal_share"), testing::ElementsAre("")) << id;
  }
  study.goals = {{.method = "de_casteljau", .share = 0.7, .from_degree = 10, .to_degree = 20},
                 {.method = "horner_bernstein_fma", .share = 0.7, .from_degree = 21},
                 {.method = "de_casteljau_lerp_fma", .share = 0.7, .to_degree = 19},
                 {.method = "exact_dd:horner_dd", .share = 0.7, .scalar = suite::ScalarKind::float32}};
  const auto table = written(study);
  EXPECT_THAT(values(table, "de_casteljau", "goal_share"), testing::ElementsAre("0.7"));
  for (const auto* id : {"horner_bernstein_fma", "de_casteljau_lerp_fma", "exact_dd:horner_dd"})
    EXPECT_THAT(values(table, id, "goal_share"), testing::ElementsAre("")) << id;
}

TEST_F(Roofline, AdditionsMustRunBesideForAGoalAboveThePeak) {
  const auto table = written(roofline_study(), [](const TargetRival& who) {
    return who.work == Work::multiply_add_and_add ? 1.0 / 8 : all_alike(who);
  });
  EXPECT_THAT(values(table, "de_casteljau_lerp_fma", "goal_share"), testing::ElementsAre(""));
}

TEST_F(Roofline, AsksNothingInFloat) {
  auto study = roofline_study();
  study.scalar = {suite::ScalarKind::float32};
  EXPECT_THAT(values(written(study), "horner_bernstein_fma", "goal_met"), testing::ElementsAre(""));
}

TEST_F(Roofline, RunsAndChecksWhatItTimes) {
  auto study = roofline_study();
  study.degree = {3};
  const auto races = roofline_races_of(study);
  race::RaceOptions options;
  options.rounds = 1;
  options.min_rounds = 1;
  options.rival_seconds = 0;
  const auto times = run(races[0], study, 1, options);
  ASSERT_EQ(times.size(), races[0].rivals.size());
  EXPECT_TRUE(std::ranges::all_of(times, &race::RoundTimes::checked));
}

}  // namespace
}  // namespace bezierbench::studies
