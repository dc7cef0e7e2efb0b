// SPDX-License-Identifier: MIT
// What is made of the laps of races; the laps are made up, so that no clock decides.
#include "experiments/studies/heat.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "experiments/bundle/csv.hpp"
#include "experiments/failure.hpp"
#include "experiments/studies/complexity_rows.hpp"
#include "experiments/studies/timed_problem.hpp"
#include "experiments/studies/timing.hpp"
#include "experiments/studies/timing_rows.hpp"

namespace bezierbench::studies {
namespace {

using testing::ElementsAre;

suite::Study timing_study() {
  suite::Study study;
  study.id = "s";
  study.kind = suite::Kind::timing;
  study.degree = {3, 5, 10, 20};
  study.methods = {"horner_bernstein", "de_casteljau"};  // the roster has them the other way round
  study.modes = {suite::Mode::point};
  return study;
}

timing::Lap sitting_of(double ns) {
  timing::Lap sitting;
  sitting.ns_per_point.assign(2, ns);
  sitting.points_per_round = 256;
  return sitting;
}

HeatLap lap_of(double ns, std::size_t sittings = 12) { return {std::vector<timing::Lap>(sittings, sitting_of(ns))}; }

/// A heat of de Casteljau, n^2 ns, and Horner-Bernstein, 2 n ns.
void make_up(Heat& heat, double chain_ns = 1, double sweep_ns = 0.5) {
  const double n = heat.cell.degree;
  heat.laps = {lap_of(n * n), lap_of(2 * n), lap_of(sweep_ns), lap_of(chain_ns)};
}

std::vector<Heat> made_up_heats(const suite::Study& study) {
  auto heats = heats_of(study);
  for (auto& heat : heats) make_up(heat);
  return heats;
}

bundle::CsvDocument timing_csv(const suite::Study& study, const std::vector<Heat>& heats) {
  Tables tables;
  write_timing_rows(study, heats, tables);
  return bundle::parse_csv(tables.all().at("timing.csv").text(), "timing.csv");
}

bundle::CsvDocument complexity_csv(const suite::Study& study, const std::vector<Heat>& heats) {
  Tables tables;
  write_complexity_rows(study, heats, timed_problem(study).size, tables);
  return bundle::parse_csv(tables.all().at("complexity.csv").text(), "complexity.csv");
}

std::vector<std::string> column(const bundle::CsvDocument& document, std::string_view name) {
  std::vector<std::string> values;
  for (std::size_t row = 0; row < document.row_count(); ++row) values.push_back(document.at(row, name));
  return values;
}

TEST(Heat, EveryScalarCellAndModeIsOne) {
  auto study = timing_study();
  study.scalar = {suite::ScalarKind::float64, suite::ScalarKind::float32};
  study.modes = {suite::Mode::point, suite::Mode::batch, suite::Mode::latency};
  study.dimension = {1, 2};
  EXPECT_EQ(heats_of(study).size(), 2U * 3 * 2 * 4);
}

TEST(Heat, HoldsTheMethodsOfItsScalarType) {
  auto study = timing_study();
  study.degree = {100};
  study.methods = {"direct", "de_casteljau"};
  study.scalar = {suite::ScalarKind::float64, suite::ScalarKind::float32};
  const auto heats = heats_of(study);
  EXPECT_EQ(heats[0].methods.size(), 2U);
  EXPECT_EQ(heats[1].methods.size(), 1U) << "factorials of 100 overflow in float";
}

TEST(Heat, RatiosAreRelativeToTheMethodNamedFirst) {
  auto study = timing_study();
  EXPECT_EQ(relative_to(heats_of(study)[0], study), 1U);
  study.baseline = {"de_casteljau"};
  EXPECT_EQ(relative_to(heats_of(study)[0], study), 0U);
  study.baseline = {"exact"};
  study.methods.clear();
  EXPECT_EQ(relative_to(heats_of(study)[0], study), 0U);
}

TEST(Heat, ABaselineThatCannotRaceHasNoRatios) {
  auto study = timing_study();
  study.degree = {170, 171};
  study.methods = {"direct", "de_casteljau"};
  EXPECT_EQ(heats_of(study)[1].methods.size(), 1U);
  EXPECT_EQ(relative_to(heats_of(study)[1], study), 0U) << "none is named: the first that is there";
  study.baseline = {"direct"};
  EXPECT_EQ(relative_to(heats_of(study)[0], study), 0U);
  EXPECT_EQ(relative_to(heats_of(study)[1], study), std::nullopt);
  EXPECT_NO_THROW(timing_job(study, {}));
  study.baseline = {"volk_schumaker"};
  EXPECT_THROW(timing_job(study, {}), Failure);
}

Heat one_heat(const suite::Study& study) {
  Heat heat = heats_of(study)[0];
  make_up(heat);
  return heat;
}

TEST(TimingRows, RatiosAreTakenRoundByRound) {
  const auto study = timing_study();
  Heat heat = one_heat(study);
  for (std::size_t sitting = 0; sitting < 12; ++sitting)
    for (std::size_t round = 0; round < 2; ++round) {  // a machine that grows slower, by more than any method differs
      const auto machine = static_cast<double>(1 + 2 * sitting + round);
      heat.laps[0].sittings[sitting].ns_per_point[round] = 3 * machine;
      heat.laps[1].sittings[sitting].ns_per_point[round] = 2 * machine;
    }
  const auto csv = timing_csv(study, {heat});
  EXPECT_THAT(column(csv, "method"), ElementsAre("de_casteljau", "horner_bernstein", "sentinel"));
  EXPECT_THAT(column(csv, "relative_to"), ElementsAre("horner_bernstein", "horner_bernstein", ""));
  EXPECT_THAT(column(csv, "ratio"), ElementsAre("1.5", "1", ""));
  EXPECT_THAT(column(csv, "ratio_low"), ElementsAre("1.5", "1", ""));
  EXPECT_THAT(column(csv, "ratio_high"), ElementsAre("1.5", "1", ""));
  EXPECT_THAT(column(csv, "degree"), ElementsAre("3", "3", ""));
}

// Many rounds of a sitting say nothing of what the next sitting would give.
TEST(TimingRows, IntervalsOfRatiosAreOverSittings) {
  const auto study = timing_study();
  Heat heat = one_heat(study);
  for (std::size_t sitting = 0; sitting < 12; ++sitting) {
    heat.laps[0].sittings[sitting].ns_per_point.assign(100, 6 * (1 + 0.25 * static_cast<double>(sitting)));
    heat.laps[1].sittings[sitting].ns_per_point.assign(100, 6);
  }
  const auto csv = timing_csv(study, {heat});
  EXPECT_EQ(csv.at(0, "ratio"), "2.375") << "between the sixth and the seventh";
  EXPECT_EQ(csv.at(0, "ratio_low"), "1.25") << "the second";
  EXPECT_EQ(csv.at(0, "ratio_high"), "3.5") << "the eleventh";
  EXPECT_EQ(csv.at(0, "rounds"), "1200");
}

TEST(TimingRows, TimesAreOverSittingsAlsoInUnitsOfTheirSentinels) {
  const auto study = timing_study();
  Heat heat = one_heat(study);
  heat.laps = {lap_of(0, 8), lap_of(0, 8), lap_of(0, 8), lap_of(0, 8)};
  for (std::size_t sitting = 0; sitting < 8; ++sitting) {
    const double machine = 1 + static_cast<double>(sitting);
    heat.laps[0].sittings[sitting] = sitting_of(3 * machine);
    heat.laps[1].sittings[sitting] = sitting_of(10);  // in fewer and fewer units
    heat.laps[2].sittings[sitting] = sitting_of(machine / 4);
    heat.laps[3].sittings[sitting] = sitting_of(machine);
  }
  const auto csv = timing_csv(study, {heat});
  EXPECT_THAT(column(csv, "median_ns"), ElementsAre("13.5", "10", "4.5"));
  EXPECT_THAT(column(csv, "low_ns"), ElementsAre("3", "10", "1"));
  EXPECT_THAT(column(csv, "high_ns"), ElementsAre("24", "10", "8"));
  EXPECT_THAT(column(csv, "sittings"), ElementsAre("8", "8", "8"));
  EXPECT_THAT(column(csv, "sentinel_units_low"), ElementsAre("3", "1.25", ""));
  EXPECT_THAT(column(csv, "sentinel_units"), ElementsAre("3", "2.25", ""));  // between 10/5 and 10/4
  EXPECT_THAT(column(csv, "sentinel_units_high"), ElementsAre("3", "10", ""));
  EXPECT_THAT(column(csv, "sentinel_ns"), ElementsAre("4.5", "4.5", "4.5"));
  EXPECT_THAT(column(csv, "sweep_ns"), ElementsAre("1.125", "1.125", "1.125"));
}

TEST(TimingRows, CountsAreMediansOrEmpty) {
  const auto study = timing_study();
  Heat heat = one_heat(study);
  heat.laps[0].sittings[0].cycles_per_point = {4, 3};
  heat.laps[0].sittings[1].cycles_per_point = {5};
  heat.laps[0].sittings[2].instructions_per_point = {7, 9, 8};
  const auto csv = timing_csv(study, {heat});
  EXPECT_THAT(column(csv, "cycles"), ElementsAre("4", "", ""));
  EXPECT_THAT(column(csv, "instructions"), ElementsAre("8", "", ""));
}

TEST(TimingRows, SayWhatTheSentinelSaw) {
  const auto study = timing_study();
  auto heats = made_up_heats(study);
  make_up(heats[1], 1.019);  // within what is tolerated
  make_up(heats[2], 1.021);  // steady, but slower than the others
  auto& chain = heats[3].laps.back().sittings;
  chain[9] = sitting_of(5);  // one disturbed sitting is what medians are for
  const auto csv = timing_csv(study, heats);
  EXPECT_THAT(column(csv, "quality"), ElementsAre("ok", "ok", "ok", "ok", "noisy", "noisy", "ok", "ok", "noisy"));
  for (std::size_t sitting = 3; sitting < 12; ++sitting) chain[sitting] = sitting_of(1.03);
  EXPECT_EQ(timing_csv(study, heats).at(6, "quality"), "noisy") << "slower in most sittings";
}

// Another thread on the same core slows the sweep down, but hardly the chain.
TEST(TimingRows, TheSecondSentinelSeesWhatTheFirstDoesNot) {
  const auto study = timing_study();
  auto heats = made_up_heats(study);
  make_up(heats[1], 1, 0.5 * 1.021);
  const auto csv = timing_csv(study, heats);
  EXPECT_THAT(column(csv, "quality"), ElementsAre("ok", "ok", "noisy", "noisy", "ok", "ok", "ok", "ok", "noisy"));
}

// Neither sentinel was slower, but three sittings of one method were.
TEST(TimingRows, SittingsThatDisagreeAreNoisy) {
  const auto study = timing_study();
  auto heats = made_up_heats(study);
  auto& sittings = heats[0].laps[0].sittings;
  for (const std::size_t disturbed : {2U, 5U}) sittings[disturbed] = sitting_of(9 * 1.7);
  EXPECT_EQ(timing_csv(study, heats).at(0, "quality"), "ok") << "fewer than a quarter";
  for (const std::size_t disturbed : {8U, 9U}) sittings[disturbed] = sitting_of(9 * 1.7);
  EXPECT_EQ(timing_csv(study, heats).at(0, "quality"), "noisy");
  EXPECT_EQ(timing_csv(study, heats).at(1, "quality"), "ok") << "the other method";
  for (auto& sitting : sittings) sitting = sitting_of(9 * 1.7);
  EXPECT_EQ(timing_csv(study, heats).at(0, "quality"), "ok") << "they agree";
}

TEST(HeatLaps, SittingsCanComeInAnyOrder) {
  const auto one = HeatLaps{{lap_of(3, 1), lap_of(1, 1)}};
  const auto two = HeatLaps{{lap_of(5, 1), lap_of(2, 1)}};
  HeatLaps forth;
  forth.merge(one);
  forth.merge(two);
  EXPECT_THAT(forth.each[0].sitting_ns(), ElementsAre(3, 5));
  EXPECT_THAT(forth.each[1].sitting_ns(), ElementsAre(1, 2));
  EXPECT_EQ(forth.each[0].rounds().ns_per_point.size(), 4U);
  HeatLaps back = two;
  back.merge(one);
  EXPECT_THAT(back.each[0].sitting_ns(), ElementsAre(5, 3));
  EXPECT_THROW(back.merge(HeatLaps{{lap_of(1)}}), std::invalid_argument);
}

TEST(HeatLaps, OneSittingThatFoundPointsWrongSpoilsAll) {
  auto wrong = HeatLaps{{lap_of(3, 1)}};
  wrong.each[0].sittings[0].checked = false;
  auto laps = HeatLaps{{lap_of(3, 1)}};
  laps.merge(wrong);
  EXPECT_FALSE(laps.each[0].rounds().checked);
}

TEST(TimingRows, OnlyHeatsThatRanHaveRows) {
  const auto study = timing_study();
  EXPECT_EQ(timing_csv(study, heats_of(study)).row_count(), 0U);
}

TEST(ComplexityRows, FitTheDegreesOfAStudyAgainstTheClaim) {
  const auto study = timing_study();
  auto heats = made_up_heats(study);
  const auto csv = complexity_csv(study, heats);
  EXPECT_THAT(column(csv, "method"), ElementsAre("de_casteljau", "horner_bernstein"));
  EXPECT_THAT(column(csv, "claimed"), ElementsAre("2", "1"));
  EXPECT_THAT(column(csv, "verdict"), ElementsAre("within", "within"));
  EXPECT_THAT(column(csv, "first_degree"), ElementsAre("3", "3"));
  EXPECT_THAT(column(csv, "last_degree"), ElementsAre("20", "20"));
  EXPECT_NEAR(std::stod(csv.at(0, "exponent")), 2, 1e-12);
  EXPECT_NEAR(std::stod(csv.at(1, "exponent")), 1, 1e-12);
  for (auto& heat : heats) std::swap(heat.laps[0], heat.laps[1]);
  EXPECT_THAT(column(complexity_csv(study, heats), "verdict"), ElementsAre("within", "above"));
}

TEST(ComplexityRows, OneShotIsChargedWithPreparing) {
  auto study = timing_study();
  study.methods = {"differences:horner"};
  study.modes = {suite::Mode::point, suite::Mode::one_shot};
  auto heats = heats_of(study);
  for (auto& heat : heats) heat.laps = {lap_of(heat.cell.degree), lap_of(1), lap_of(1)};
  const auto csv = complexity_csv(study, heats);
  EXPECT_THAT(column(csv, "mode"), ElementsAre("point", "one_shot"));
  EXPECT_THAT(column(csv, "claimed"), ElementsAre("1", "2"));
}

TEST(ComplexityRows, NeedThreeDegrees) {
  auto study = timing_study();
  study.degree = {3, 5};
  EXPECT_EQ(complexity_csv(study, made_up_heats(study)).row_count(), 0U);
}

}  // namespace
}  // namespace bezierbench::studies
