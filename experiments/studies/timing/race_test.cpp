// SPDX-License-Identifier: MIT
// The rows of races with made-up times, so that no clock decides.
#include "experiments/race/race.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "experiments/bundle/csv.hpp"
#include "experiments/failure.hpp"
#include "experiments/studies/roster.hpp"
#include "experiments/studies/timing/timing_rows.hpp"

namespace bezierbench::studies {
namespace {

using testing::ElementsAre;

suite::Study timing_study() {
  suite::Study study;
  study.id = "s";
  study.kind = &kind("timing");
  study.modes = {suite::Mode::point};
  study.degree = {3, 5, 10, 20};
  study.methods = {"horner_bernstein", "de_casteljau"};  // the roster has them the other way round
  return study;
}

race::RoundTimes repetition_of(double ns) {
  race::RoundTimes repetition;
  repetition.ns_per_point.assign(2, ns);
  repetition.points_per_round = 256;
  return repetition;
}

race::RivalTimes rival_times(double ns, std::size_t repetitions = 12) {
  return {std::vector<race::RoundTimes>(repetitions, repetition_of(ns))};
}

/// A race of de Casteljau, n^2 ns, and Horner-Bernstein, 2 n ns.
void make_up(race::Race& race, double chain_ns = 1, double sweep_ns = 0.5) {
  const double n = race.cell.degree;
  race.times = {rival_times(n * n), rival_times(2 * n), rival_times(sweep_ns), rival_times(chain_ns)};
}

std::vector<race::Race> made_up_races(const suite::Study& study) {
  auto races = timed_problem(study).races(study);
  for (auto& race : races) make_up(race);
  return races;
}

bundle::CsvDocument timing_csv(const suite::Study& study, const std::vector<race::Race>& races) {
  tables::Tables tables;
  studies::write_timing_rows(study, races, tables);
  return bundle::parse_csv(tables.all().at("timing.csv").text(), "timing.csv");
}

bundle::CsvDocument complexity_csv(const suite::Study& study, const std::vector<race::Race>& races) {
  tables::Tables tables;
  studies::write_complexity_rows(study, races, timed_problem(study).size, tables);
  return bundle::parse_csv(tables.all().at("complexity.csv").text(), "complexity.csv");
}

std::vector<std::string> column(const bundle::CsvDocument& document, std::string_view name) {
  std::vector<std::string> values;
  for (std::size_t row = 0; row < document.row_count(); ++row) values.push_back(document.at(row, name));
  return values;
}

TEST(Race, EveryScalarCellAndModeIsOne) {
  auto study = timing_study();
  study.scalar = {suite::ScalarKind::float64, suite::ScalarKind::float32};
  study.modes = {suite::Mode::point, suite::Mode::batch, suite::Mode::latency};
  study.dimension = {1, 2};
  EXPECT_EQ(timed_problem(study).races(study).size(), 2U * 3 * 2 * 4);
}

TEST(Race, HoldsTheMethodsOfItsScalarType) {
  auto study = timing_study();
  study.degree = {100};
  study.methods = {"direct", "de_casteljau"};
  study.scalar = {suite::ScalarKind::float64, suite::ScalarKind::float32};
  const auto races = timed_problem(study).races(study);
  EXPECT_EQ(races[0].methods.size(), 2U);
  EXPECT_EQ(races[1].methods.size(), 1U) << "factorials of 100 overflow in float";
}

TEST(Race, RatiosAreRelativeToTheMethodNamedFirst) {
  auto study = timing_study();
  EXPECT_EQ(race::relative_to(timed_problem(study).races(study)[0], study), 1U);
  study.baseline = {"de_casteljau"};
  EXPECT_EQ(race::relative_to(timed_problem(study).races(study)[0], study), 0U);
  study.baseline = {"exact"};
  study.methods.clear();
  EXPECT_EQ(race::relative_to(timed_problem(study).races(study)[0], study), 0U);
}

TEST(Race, ABaselineThatCannotRaceHasNoRatios) {
  auto study = timing_study();
  study.degree = {170, 171};
  study.methods = {"direct", "de_casteljau"};
  EXPECT_EQ(timed_problem(study).races(study)[1].methods.size(), 1U);
  EXPECT_EQ(race::relative_to(timed_problem(study).races(study)[1], study), 0U)
      << "none is named: the first that is there";
  study.baseline = {"direct"};
  EXPECT_EQ(race::relative_to(timed_problem(study).races(study)[0], study), 0U);
  EXPECT_EQ(race::relative_to(timed_problem(study).races(study)[1], study), std::nullopt);
  EXPECT_NO_THROW(studies::make_job(study, {}));
  study.baseline = {"volk_schumaker"};
  EXPECT_THROW(studies::make_job(study, {}), Failure);
}

race::Race one_heat(const suite::Study& study) {
  race::Race race = timed_problem(study).races(study)[0];
  make_up(race);
  return race;
}

TEST(TimingRows, RatiosAreTakenRoundByRound) {
  const auto study = timing_study();
  race::Race race = one_heat(study);
  for (std::size_t repetition = 0; repetition < 12; ++repetition)
    for (std::size_t round = 0; round < 2; ++round) {  // a machine that grows slower, by more than any method differs
      const auto machine = static_cast<double>(1 + 2 * repetition + round);
      race.times[0].repetitions[repetition].ns_per_point[round] = 3 * machine;
      race.times[1].repetitions[repetition].ns_per_point[round] = 2 * machine;
    }
  const auto csv = timing_csv(study, {race});
  EXPECT_THAT(column(csv, "method"), ElementsAre("de_casteljau", "horner_bernstein", "sentinel"));
  EXPECT_THAT(column(csv, "relative_to"), ElementsAre("horner_bernstein", "horner_bernstein", ""));
  EXPECT_THAT(column(csv, "ratio"), ElementsAre("1.5", "1", ""));
  EXPECT_THAT(column(csv, "ratio_low"), ElementsAre("1.5", "1", ""));
  EXPECT_THAT(column(csv, "ratio_high"), ElementsAre("1.5", "1", ""));
  EXPECT_THAT(column(csv, "degree"), ElementsAre("3", "3", ""));
}

/// Every operation takes 1 ns, and 10 ns in a chain.
race::ProcessorTimes made_up_times() {
  return {{.lanes = 2, .apart = {{1, 1, 1, 1, 1}}, .latency = {{10, 10, 10, 10, 10}}, .mixed = 1}};
}

// At degree 3: 1 - t and 18 operations on each axis; 1 - t and 3 steps of a power, two products and a sum.
TEST(TimingRows, SayHowNearTimesAreToTheLimit) {
  const auto study = timing_study();
  race::Race race = one_heat(study);
  race.times = {rival_times(50), rival_times(12), rival_times(12), rival_times(0.5), rival_times(1)};
  race.operations.assign(12, made_up_times());
  const auto csv = timing_csv(study, {race});
  EXPECT_THAT(column(csv, "method"), ElementsAre("de_casteljau", "horner_bernstein", "sentinel"));
  EXPECT_THAT(column(csv, "call_ns"), ElementsAre("12", "12", ""));
  EXPECT_THAT(column(csv, "limit_ns"), ElementsAre("19", "13", ""));
  EXPECT_THAT(column(csv, "share_of_limit"), ElementsAre("0.5", "inf", ""));
  EXPECT_THAT(column(csv, "chain_ns"), ElementsAre("70", "70", ""));
  EXPECT_THAT(column(csv, "sweep_ns"), ElementsAre("0.5", "0.5", "0.5")) << "the call is not a sentinel";
}

TEST(TimingRows, WithoutAnEmptyKernelHaveNoLimit) {
  const auto study = timing_study();
  const auto csv = timing_csv(study, {one_heat(study)});
  EXPECT_THAT(column(csv, "call_ns"), ElementsAre("", "", ""));
  EXPECT_THAT(column(csv, "limit_ns"), ElementsAre("", "", ""));
}

TEST(Race, AddsRepetitionsUp) {
  race::RaceTimes all;
  for (const double error : {2.0, 5.0, 3.0}) {
    race::RaceTimes one{{rival_times(1, 1)}, {made_up_times()}};
    one.each[0].max_error_u = error;
    all.merge(one);
  }
  EXPECT_EQ(all.each[0].repetitions.size(), 3U);
  EXPECT_EQ(all.each[0].max_error_u, 5);
  EXPECT_EQ(all.operations.size(), 3U);
}

// Many rounds of one repetition do not predict the next repetition.
TEST(TimingRows, IntervalsOfRatiosAreOverRepetitions) {
  const auto study = timing_study();
  race::Race race = one_heat(study);
  for (std::size_t repetition = 0; repetition < 12; ++repetition) {
    race.times[0].repetitions[repetition].ns_per_point.assign(100, 6 * (1 + 0.25 * static_cast<double>(repetition)));
    race.times[1].repetitions[repetition].ns_per_point.assign(100, 6);
  }
  const auto csv = timing_csv(study, {race});
  EXPECT_EQ(csv.at(0, "ratio"), "2.375") << "between the sixth and the seventh";
  EXPECT_EQ(csv.at(0, "ratio_low"), "1.25") << "the second";
  EXPECT_EQ(csv.at(0, "ratio_high"), "3.5") << "the eleventh";
  EXPECT_EQ(csv.at(0, "rounds"), "1200");
}

TEST(TimingRows, TimesAreOverRepetitionsAlsoInUnitsOfTheirSentinels) {
  const auto study = timing_study();
  race::Race race = one_heat(study);
  race.times = {rival_times(0, 8), rival_times(0, 8), rival_times(0, 8), rival_times(0, 8)};
  for (std::size_t repetition = 0; repetition < 8; ++repetition) {
    const double machine = 1 + static_cast<double>(repetition);
    race.times[0].repetitions[repetition] = repetition_of(3 * machine);
    race.times[1].repetitions[repetition] = repetition_of(10);  // in fewer and fewer units
    race.times[2].repetitions[repetition] = repetition_of(machine / 4);
    race.times[3].repetitions[repetition] = repetition_of(machine);
  }
  const auto csv = timing_csv(study, {race});
  EXPECT_THAT(column(csv, "median_ns"), ElementsAre("13.5", "10", "4.5"));
  EXPECT_THAT(column(csv, "low_ns"), ElementsAre("3", "10", "1"));
  EXPECT_THAT(column(csv, "high_ns"), ElementsAre("24", "10", "8"));
  EXPECT_THAT(column(csv, "repetitions"), ElementsAre("8", "8", "8"));
  EXPECT_THAT(column(csv, "sentinel_units_low"), ElementsAre("3", "1.25", ""));
  EXPECT_THAT(column(csv, "sentinel_units"), ElementsAre("3", "2.25", ""));  // between 10/5 and 10/4
  EXPECT_THAT(column(csv, "sentinel_units_high"), ElementsAre("3", "10", ""));
  EXPECT_THAT(column(csv, "sentinel_ns"), ElementsAre("4.5", "4.5", "4.5"));
  EXPECT_THAT(column(csv, "sweep_ns"), ElementsAre("1.125", "1.125", "1.125"));
}

TEST(TimingRows, CountsAreMediansOrEmpty) {
  const auto study = timing_study();
  race::Race race = one_heat(study);
  race.times[0].repetitions[0].cycles_per_point = {4, 3};
  race.times[0].repetitions[1].cycles_per_point = {5};
  race.times[0].repetitions[2].instructions_per_point = {7, 9, 8};
  const auto csv = timing_csv(study, {race});
  EXPECT_THAT(column(csv, "cycles"), ElementsAre("4", "", ""));
  EXPECT_THAT(column(csv, "instructions"), ElementsAre("8", "", ""));
}

TEST(TimingRows, SayWhetherATimeMayBeCompared) {
  const auto study = timing_study();
  auto races = made_up_races(study);
  races[1].times[0] = rival_times(9, 7);
  races[2].times[1].repetitions[3].checked = false;
  const auto csv = timing_csv(study, races);
  EXPECT_THAT(column(csv, "quality"), ElementsAre("ok", "ok", "few_rounds", "ok", "ok", "unchecked", "ok", "ok", "ok"));
  EXPECT_EQ(csv.at(5, "checked"), "no");
}

/// Counts come without times, as they do in a study that only counts.
TEST(CostRows, AreOfTheCountedRaces) {
  const auto study = timing_study();
  auto races = timed_problem(study).races(study);
  races[1].counts = {{.instructions = 40, .loads = 12, .stores = 2, .branches = 1, .target = ""},
                     {.instructions = 20.5, .loads = 8, .stores = 2, .branches = 1, .target = "AVX2"}};
  tables::Tables tables;
  write_cost_rows(study, races, tables);
  const auto csv = bundle::parse_csv(tables.all().at("cost.csv").text(), "cost.csv");
  EXPECT_THAT(column(csv, "degree"), ElementsAre("5", "5"));
  EXPECT_THAT(column(csv, "method"), ElementsAre("de_casteljau", "horner_bernstein"));
  EXPECT_THAT(column(csv, "instructions"), ElementsAre("40", "20.5"));
  EXPECT_THAT(column(csv, "target"), ElementsAre("", "AVX2"));
}

TEST(RaceTimes, RepetitionsCanComeInAnyOrder) {
  const auto one = race::RaceTimes{{rival_times(3, 1), rival_times(1, 1)}};
  const auto two = race::RaceTimes{{rival_times(5, 1), rival_times(2, 1)}};
  race::RaceTimes forth;
  forth.merge(one);
  forth.merge(two);
  EXPECT_THAT(forth.each[0].repetition_ns(), ElementsAre(3, 5));
  EXPECT_THAT(forth.each[1].repetition_ns(), ElementsAre(1, 2));
  EXPECT_EQ(forth.each[0].rounds().ns_per_point.size(), 4U);
  race::RaceTimes back = two;
  back.merge(one);
  EXPECT_THAT(back.each[0].repetition_ns(), ElementsAre(5, 3));
  EXPECT_THROW(back.merge(race::RaceTimes{{rival_times(1)}}), std::invalid_argument);
}

TEST(RaceTimes, OneRepetitionThatFoundPointsWrongSpoilsAll) {
  auto wrong = race::RaceTimes{{rival_times(3, 1)}};
  wrong.each[0].repetitions[0].checked = false;
  auto times = race::RaceTimes{{rival_times(3, 1)}};
  times.merge(wrong);
  EXPECT_FALSE(times.each[0].rounds().checked);
}

TEST(TimingRows, OnlyRaceCellsThatRanHaveRows) {
  const auto study = timing_study();
  EXPECT_EQ(timing_csv(study, timed_problem(study).races(study)).row_count(), 0U);
}

TEST(ComplexityRows, FitTheDegreesOfAStudyAgainstTheClaim) {
  const auto study = timing_study();
  auto races = made_up_races(study);
  const auto csv = complexity_csv(study, races);
  EXPECT_THAT(column(csv, "method"), ElementsAre("de_casteljau", "horner_bernstein"));
  EXPECT_THAT(column(csv, "claimed"), ElementsAre("2", "1"));
  EXPECT_THAT(column(csv, "verdict"), ElementsAre("within", "within"));
  EXPECT_THAT(column(csv, "first_degree"), ElementsAre("3", "3"));
  EXPECT_THAT(column(csv, "last_degree"), ElementsAre("20", "20"));
  EXPECT_NEAR(std::stod(csv.at(0, "exponent")), 2, 1e-12);
  EXPECT_NEAR(std::stod(csv.at(1, "exponent")), 1, 1e-12);
  for (auto& race : races) std::swap(race.times[0], race.times[1]);
  EXPECT_THAT(column(complexity_csv(study, races), "verdict"), ElementsAre("within", "above"));
}

TEST(ComplexityRows, OneShotIsChargedWithPreparing) {
  auto study = timing_study();
  study.methods = {"differences:horner"};
  study.modes = {suite::Mode::point, suite::Mode::one_shot};
  auto races = timed_problem(study).races(study);
  for (auto& race : races) race.times = {rival_times(race.cell.degree), rival_times(1), rival_times(1)};
  const auto csv = complexity_csv(study, races);
  EXPECT_THAT(column(csv, "mode"), ElementsAre("point", "one_shot"));
  EXPECT_THAT(column(csv, "claimed"), ElementsAre("1", "2"));
}

TEST(ComplexityRows, NeedThreeDegrees) {
  auto study = timing_study();
  study.degree = {3, 5};
  EXPECT_EQ(complexity_csv(study, made_up_races(study)).row_count(), 0U);
}

}  // namespace
}  // namespace bezierbench::studies
