// SPDX-License-Identifier: MIT
// What is made of the laps of races; the laps are made up, so that no clock decides.
#include "experiments/race/race_cell.hpp"

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

race::Lap repetition_of(double ns) {
  race::Lap repetition;
  repetition.ns_per_point.assign(2, ns);
  repetition.points_per_round = 256;
  return repetition;
}

race::RaceCellLap lap_of(double ns, std::size_t repetitions = 12) {
  return {std::vector<race::Lap>(repetitions, repetition_of(ns))};
}

/// A race cell of de Casteljau, n^2 ns, and Horner-Bernstein, 2 n ns.
void make_up(race::RaceCell& race_cell, double chain_ns = 1, double sweep_ns = 0.5) {
  const double n = race_cell.cell.degree;
  race_cell.laps = {lap_of(n * n), lap_of(2 * n), lap_of(sweep_ns), lap_of(chain_ns)};
}

std::vector<race::RaceCell> made_up_race_cells(const suite::Study& study) {
  auto race_cells = timed_problem(study).race_cells(study);
  for (auto& race_cell : race_cells) make_up(race_cell);
  return race_cells;
}

bundle::CsvDocument timing_csv(const suite::Study& study, const std::vector<race::RaceCell>& race_cells) {
  tables::Tables tables;
  studies::write_timing_rows(study, race_cells, tables);
  return bundle::parse_csv(tables.all().at("timing.csv").text(), "timing.csv");
}

bundle::CsvDocument complexity_csv(const suite::Study& study, const std::vector<race::RaceCell>& race_cells) {
  tables::Tables tables;
  studies::write_complexity_rows(study, race_cells, timed_problem(study).size, tables);
  return bundle::parse_csv(tables.all().at("complexity.csv").text(), "complexity.csv");
}

std::vector<std::string> column(const bundle::CsvDocument& document, std::string_view name) {
  std::vector<std::string> values;
  for (std::size_t row = 0; row < document.row_count(); ++row) values.push_back(document.at(row, name));
  return values;
}

TEST(RaceCell, HoldsTheMethodsOfItsScalarType) {
  auto study = timing_study();
  study.degree = {100};
  study.methods = {"direct", "de_casteljau"};
  study.scalar = {suite::ScalarKind::float64, suite::ScalarKind::float32};
  const auto race_cells = timed_problem(study).race_cells(study);
  EXPECT_EQ(race_cells[0].methods.size(), 2U);
  EXPECT_EQ(race_cells[1].methods.size(), 1U) << "factorials of 100 overflow in float";
}

TEST(RaceCell, RatiosAreRelativeToTheMethodNamedFirst) {
  auto study = timing_study();
  EXPECT_EQ(race::relative_to(timed_problem(study).race_cells(study)[0], study), 1U);
  study.baseline = {"de_casteljau"};
  EXPECT_EQ(race::relative_to(timed_problem(study).race_cells(study)[0], study), 0U);
  study.baseline = {"exact"};
  study.methods.clear();
  EXPECT_EQ(race::relative_to(timed_problem(study).race_cells(study)[0], study), 0U);
}

TEST(RaceCell, ABaselineThatCannotRaceHasNoRatios) {
  auto study = timing_study();
  study.degree = {170, 171};
  study.methods = {"direct", "de_casteljau"};
  EXPECT_EQ(timed_problem(study).race_cells(study)[1].methods.size(), 1U);
  EXPECT_EQ(race::relative_to(timed_problem(study).race_cells(study)[1], study), 0U)
      << "none is named: the first that is there";
  study.baseline = {"direct"};
  EXPECT_EQ(race::relative_to(timed_problem(study).race_cells(study)[0], study), 0U);
  EXPECT_EQ(race::relative_to(timed_problem(study).race_cells(study)[1], study), std::nullopt);
  EXPECT_NO_THROW(studies::make_job(study, {}));
  study.baseline = {"volk_schumaker"};
  EXPECT_THROW(studies::make_job(study, {}), Failure);
}

race::RaceCell one_heat(const suite::Study& study) {
  race::RaceCell race_cell = timed_problem(study).race_cells(study)[0];
  make_up(race_cell);
  return race_cell;
}

TEST(TimingRows, RatiosAreTakenRoundByRound) {
  const auto study = timing_study();
  race::RaceCell race_cell = one_heat(study);
  for (std::size_t repetition = 0; repetition < 12; ++repetition)
    for (std::size_t round = 0; round < 2; ++round) {  // a machine that grows slower, by more than any method differs
      const auto machine = static_cast<double>(1 + 2 * repetition + round);
      race_cell.laps[0].repetitions[repetition].ns_per_point[round] = 3 * machine;
      race_cell.laps[1].repetitions[repetition].ns_per_point[round] = 2 * machine;
    }
  const auto csv = timing_csv(study, {race_cell});
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
  race::RaceCell race_cell = one_heat(study);
  race_cell.laps = {lap_of(50), lap_of(12), lap_of(12), lap_of(0.5), lap_of(1)};
  race_cell.operations.assign(12, made_up_times());
  const auto csv = timing_csv(study, {race_cell});
  EXPECT_THAT(column(csv, "method"), ElementsAre("de_casteljau", "horner_bernstein", "sentinel"));
  EXPECT_THAT(column(csv, "call_ns"), ElementsAre("12", "12", ""));
  EXPECT_THAT(column(csv, "limit_ns"), ElementsAre("19", "13", ""));
  EXPECT_THAT(column(csv, "share_of_limit"), ElementsAre("0.5", "inf", ""));
  EXPECT_THAT(column(csv, "chain_ns"), ElementsAre("70", "70", ""));
  EXPECT_THAT(column(csv, "sweep_ns"), ElementsAre("0.5", "0.5", "0.5")) << "the call is no sentinel";
}

TEST(TimingRows, WithoutAnEmptyKernelHaveNoLimit) {
  const auto study = timing_study();
  const auto csv = timing_csv(study, {one_heat(study)});
  EXPECT_THAT(column(csv, "call_ns"), ElementsAre("", "", ""));
  EXPECT_THAT(column(csv, "limit_ns"), ElementsAre("", "", ""));
}

TEST(RaceCell, AddsRepetitionsUp) {
  race::RaceCellLaps all;
  for (const double error : {2.0, 5.0, 3.0}) {
    race::RaceCellLaps one{{lap_of(1, 1)}, {made_up_times()}};
    one.each[0].max_error_u = error;
    all.merge(one);
  }
  EXPECT_EQ(all.each[0].repetitions.size(), 3U);
  EXPECT_EQ(all.each[0].max_error_u, 5);
  EXPECT_EQ(all.operations.size(), 3U);
}

// Many rounds of a repetition say nothing of what the next repetition would give.
TEST(TimingRows, IntervalsOfRatiosAreOverRepetitions) {
  const auto study = timing_study();
  race::RaceCell race_cell = one_heat(study);
  for (std::size_t repetition = 0; repetition < 12; ++repetition) {
    race_cell.laps[0].repetitions[repetition].ns_per_point.assign(100,
                                                                  6 * (1 + 0.25 * static_cast<double>(repetition)));
    race_cell.laps[1].repetitions[repetition].ns_per_point.assign(100, 6);
  }
  const auto csv = timing_csv(study, {race_cell});
  EXPECT_EQ(csv.at(0, "ratio"), "2.375") << "between the sixth and the seventh";
  EXPECT_EQ(csv.at(0, "ratio_low"), "1.25") << "the second";
  EXPECT_EQ(csv.at(0, "ratio_high"), "3.5") << "the eleventh";
  EXPECT_EQ(csv.at(0, "rounds"), "1200");
}

TEST(TimingRows, TimesAreOverRepetitionsAlsoInUnitsOfTheirSentinels) {
  const auto study = timing_study();
  race::RaceCell race_cell = one_heat(study);
  race_cell.laps = {lap_of(0, 8), lap_of(0, 8), lap_of(0, 8), lap_of(0, 8)};
  for (std::size_t repetition = 0; repetition < 8; ++repetition) {
    const double machine = 1 + static_cast<double>(repetition);
    race_cell.laps[0].repetitions[repetition] = repetition_of(3 * machine);
    race_cell.laps[1].repetitions[repetition] = repetition_of(10);  // in fewer and fewer units
    race_cell.laps[2].repetitions[repetition] = repetition_of(machine / 4);
    race_cell.laps[3].repetitions[repetition] = repetition_of(machine);
  }
  const auto csv = timing_csv(study, {race_cell});
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
  race::RaceCell race_cell = one_heat(study);
  race_cell.laps[0].repetitions[0].cycles_per_point = {4, 3};
  race_cell.laps[0].repetitions[1].cycles_per_point = {5};
  race_cell.laps[0].repetitions[2].instructions_per_point = {7, 9, 8};
  const auto csv = timing_csv(study, {race_cell});
  EXPECT_THAT(column(csv, "cycles"), ElementsAre("4", "", ""));
  EXPECT_THAT(column(csv, "instructions"), ElementsAre("8", "", ""));
}

TEST(TimingRows, SayWhatTheSentinelSaw) {
  const auto study = timing_study();
  auto race_cells = made_up_race_cells(study);
  make_up(race_cells[1], 1.019);  // within what is tolerated
  make_up(race_cells[2], 1.021);  // steady, but slower than the others
  auto& chain = race_cells[3].laps.back().repetitions;
  chain[9] = repetition_of(5);  // one disturbed repetition is what medians are for
  const auto csv = timing_csv(study, race_cells);
  EXPECT_THAT(column(csv, "quality"), ElementsAre("ok", "ok", "ok", "ok", "noisy", "noisy", "ok", "ok", "noisy"));
  for (std::size_t repetition = 3; repetition < 12; ++repetition) chain[repetition] = repetition_of(1.03);
  EXPECT_EQ(timing_csv(study, race_cells).at(6, "quality"), "noisy") << "slower in most repetitions";
}

// Another thread on the same core slows the sweep down, but hardly the chain.
TEST(TimingRows, TheSecondSentinelSeesWhatTheFirstDoesNot) {
  const auto study = timing_study();
  auto race_cells = made_up_race_cells(study);
  make_up(race_cells[1], 1, 0.5 * 1.021);
  const auto csv = timing_csv(study, race_cells);
  EXPECT_THAT(column(csv, "quality"), ElementsAre("ok", "ok", "noisy", "noisy", "ok", "ok", "ok", "ok", "noisy"));
}

// Neither sentinel was slower, but three repetitions of one method were.
TEST(TimingRows, RepetitionsThatDisagreeAreNoisy) {
  const auto study = timing_study();
  auto race_cells = made_up_race_cells(study);
  auto& repetitions = race_cells[0].laps[0].repetitions;
  for (const std::size_t disturbed : {2U, 5U}) repetitions[disturbed] = repetition_of(9 * 1.7);
  EXPECT_EQ(timing_csv(study, race_cells).at(0, "quality"), "ok") << "fewer than a quarter";
  for (const std::size_t disturbed : {8U, 9U}) repetitions[disturbed] = repetition_of(9 * 1.7);
  EXPECT_EQ(timing_csv(study, race_cells).at(0, "quality"), "noisy");
  EXPECT_EQ(timing_csv(study, race_cells).at(1, "quality"), "ok") << "the other method";
  for (auto& repetition : repetitions) repetition = repetition_of(9 * 1.7);
  EXPECT_EQ(timing_csv(study, race_cells).at(0, "quality"), "ok") << "they agree";
}

TEST(RaceCellLaps, RepetitionsCanComeInAnyOrder) {
  const auto one = race::RaceCellLaps{{lap_of(3, 1), lap_of(1, 1)}};
  const auto two = race::RaceCellLaps{{lap_of(5, 1), lap_of(2, 1)}};
  race::RaceCellLaps forth;
  forth.merge(one);
  forth.merge(two);
  EXPECT_THAT(forth.each[0].repetition_ns(), ElementsAre(3, 5));
  EXPECT_THAT(forth.each[1].repetition_ns(), ElementsAre(1, 2));
  EXPECT_EQ(forth.each[0].rounds().ns_per_point.size(), 4U);
  race::RaceCellLaps back = two;
  back.merge(one);
  EXPECT_THAT(back.each[0].repetition_ns(), ElementsAre(5, 3));
  EXPECT_THROW(back.merge(race::RaceCellLaps{{lap_of(1)}}), std::invalid_argument);
}

TEST(RaceCellLaps, OneRepetitionThatFoundPointsWrongSpoilsAll) {
  auto wrong = race::RaceCellLaps{{lap_of(3, 1)}};
  wrong.each[0].repetitions[0].checked = false;
  auto laps = race::RaceCellLaps{{lap_of(3, 1)}};
  laps.merge(wrong);
  EXPECT_FALSE(laps.each[0].rounds().checked);
}

TEST(ComplexityRows, FitTheDegreesOfAStudyAgainstTheClaim) {
  const auto study = timing_study();
  auto race_cells = made_up_race_cells(study);
  const auto csv = complexity_csv(study, race_cells);
  EXPECT_THAT(column(csv, "method"), ElementsAre("de_casteljau", "horner_bernstein"));
  EXPECT_THAT(column(csv, "claimed"), ElementsAre("2", "1"));
  EXPECT_THAT(column(csv, "verdict"), ElementsAre("within", "within"));
  EXPECT_THAT(column(csv, "first_degree"), ElementsAre("3", "3"));
  EXPECT_THAT(column(csv, "last_degree"), ElementsAre("20", "20"));
  EXPECT_NEAR(std::stod(csv.at(0, "exponent")), 2, 1e-12);
  EXPECT_NEAR(std::stod(csv.at(1, "exponent")), 1, 1e-12);
  for (auto& race_cell : race_cells) std::swap(race_cell.laps[0], race_cell.laps[1]);
  EXPECT_THAT(column(complexity_csv(study, race_cells), "verdict"), ElementsAre("within", "above"));
}

TEST(ComplexityRows, OneShotIsChargedWithPreparing) {
  auto study = timing_study();
  study.methods = {"differences:horner"};
  study.modes = {suite::Mode::point, suite::Mode::one_shot};
  auto race_cells = timed_problem(study).race_cells(study);
  for (auto& race_cell : race_cells) race_cell.laps = {lap_of(race_cell.cell.degree), lap_of(1), lap_of(1)};
  const auto csv = complexity_csv(study, race_cells);
  EXPECT_THAT(column(csv, "mode"), ElementsAre("point", "one_shot"));
  EXPECT_THAT(column(csv, "claimed"), ElementsAre("1", "2"));
}

TEST(ComplexityRows, NeedThreeDegrees) {
  auto study = timing_study();
  study.degree = {3, 5};
  EXPECT_EQ(complexity_csv(study, made_up_race_cells(study)).row_count(), 0U);
}

}  // namespace
}  // namespace bezierbench::studies
