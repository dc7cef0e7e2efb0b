// SPDX-License-Identifier: MIT
#include "experiments/studies/timing/timing_rows.hpp"

#include <algorithm>

#include "experiments/metric/order_statistics.hpp"
#include "experiments/metric/verdict.hpp"
#include "experiments/number/number.hpp"
#include "experiments/suite/names.hpp"
#include "experiments/tables/cell_fields.hpp"

namespace bezierbench::studies {
namespace {

constexpr std::string_view ok = "ok";
constexpr std::string_view noisy = "noisy";

std::string_view quality(const race::RaceCell& race_cell, const race::RaceCellLap& lap, const race::Pace& fastest) {
  return race::drifted(race_cell.laps, fastest) || race::repetitions_disagree(lap) ? noisy : ok;
}

std::vector<std::string> interval_fields(std::span<const double> sample) {
  const auto interval = metric::median_interval(sample, metric::timing_confidence);
  return {number::decimal(interval.median), number::decimal(interval.low), number::decimal(interval.high)};
}

std::vector<double> quotients(std::span<const double> a, std::span<const double> b) {
  std::vector<double> all;
  for (std::size_t k = 0; k < a.size(); ++k) all.push_back(a[k] / b[k]);
  return all;
}

/// relative_to, ratio, ratio_low, ratio_high: over repetitions, of each of which the ratio is taken round by round.
std::vector<std::string> ratio_fields(const race::RaceCell& race_cell, const race::RaceCellLap& lap,
                                      std::optional<std::size_t> base) {
  if (!base) return {"", "", "", ""};
  auto fields = interval_fields(race::repetition_ratios(lap.repetitions, race_cell.laps[*base].repetitions));
  fields.insert(fields.begin(), std::string(race_cell.methods[*base]->id));
  return fields;
}

std::string median_text(std::span<const double> counts) {
  return counts.empty() ? "" : number::decimal(metric::median_interval(counts, metric::timing_confidence).median);
}

/// What a row says apart from its lap, which gives times, rounds, counts and the check.
struct RowParts {
  std::vector<std::string> key;    ///< study to mode
  std::vector<std::string> ratio;  ///< relative_to to ratio_high
  std::string_view quality;
  std::vector<std::string> inputs;       ///< coordinate_range to generator
  std::vector<std::string> units;        ///< sentinel_units to sentinel_units_high
  std::vector<std::string> case_values;  ///< order to data
  race::Pace pace;                       ///< sentinel_ns, sweep_ns
};

void add_row(bundle::CsvTable& table, RowParts parts, const race::RaceCellLap& lap) {
  const auto rounds = lap.rounds();
  auto row = std::move(parts.key);
  const auto append = [&](const std::vector<std::string>& more) { row.insert(row.end(), more.begin(), more.end()); };
  append(interval_fields(lap.repetition_ns()));
  append({std::to_string(rounds.ns_per_point.size()), std::to_string(rounds.points_per_round)});
  append(parts.ratio);
  append({median_text(rounds.cycles_per_point), median_text(rounds.instructions_per_point), std::string(parts.quality),
          rounds.checked ? "yes" : "no"});
  append(parts.inputs);
  append({std::to_string(lap.repetitions.size())});
  append(parts.units);
  append(parts.case_values);
  append({number::decimal(parts.pace.chain_ns), number::decimal(parts.pace.sweep_ns)});
  table.add_row(std::move(row));
}

void add_race_cell(bundle::CsvTable& table, const suite::Study& study, const race::RaceCell& race_cell,
                   const race::Pace& fastest) {
  const auto base = race::relative_to(race_cell, study);
  const auto beside = race::pace(race_cell.laps);
  for (std::size_t m = 0; m < race_cell.methods.size(); ++m)
    add_row(
        table,
        {.key = {study.id, std::string(suite::name(study.curve)), std::string(race_cell.methods[m]->id),
                 std::string(suite::name(race_cell.scalar)), std::to_string(race_cell.cell.dimension),
                 std::to_string(race_cell.cell.degree), std::string(suite::name(race_cell.mode))},
         .ratio = ratio_fields(race_cell, race_cell.laps[m], base),
         .quality = quality(race_cell, race_cell.laps[m], fastest),
         .inputs = tables::drawn_fields(race_cell.cell),
         .units = interval_fields(quotients(race_cell.laps[m].repetition_ns(), race_cell.laps.back().repetition_ns())),
         .case_values = judge::case_fields(race_cell.case_values),
         .pace = beside},
        race_cell.laps[m]);
}

/// The sentinel over all race cells of a mode.
void add_sentinel(bundle::CsvTable& table, const suite::Study& study, const std::vector<race::RaceCell>& race_cells,
                  suite::Mode mode, const race::Pace& fastest) {
  race::RaceCellLaps all;
  std::string_view worst = ok;
  for (const auto& race_cell : race_cells) {
    if (race_cell.mode != mode || race_cell.laps.empty()) continue;
    all.merge({{race_cell.laps.end() - 2, race_cell.laps.end()}});
    if (race::drifted(race_cell.laps, fastest)) worst = noisy;
  }
  if (all.each.empty()) return;
  add_row(table,
          {.key = {study.id, std::string(suite::name(study.curve)), std::string(race::sentinel_name),
                   std::string(suite::name(suite::ScalarKind::float64)), "", "", std::string(suite::name(mode))},
           .ratio = {"", "", "", ""},
           .quality = worst,
           .inputs = {"", "", "", ""},
           .units = {"", "", ""},
           .case_values = judge::case_fields({}),
           .pace = race::pace(all.each)},
          all.each.back());
}

}  // namespace

void write_timing_rows(const suite::Study& study, const std::vector<race::RaceCell>& race_cells,
                       tables::Tables& tables) {
  std::vector<std::string> columns{
      "study",     "curve",      "method",  "scalar",       "dimension",        "degree",      "mode",
      "median_ns", "low_ns",     "high_ns", "rounds",       "points_per_round", "relative_to", "ratio",
      "ratio_low", "ratio_high", "cycles",  "instructions", "quality",          "checked"};
  columns.insert(columns.end(), tables::drawn_columns().begin(), tables::drawn_columns().end());
  columns.insert(columns.end(), {"sittings", "sentinel_units", "sentinel_units_low", "sentinel_units_high"});
  columns.insert(columns.end(), judge::case_columns().begin(), judge::case_columns().end());
  columns.insert(columns.end(), {"sentinel_ns", "sweep_ns"});
  auto& table = tables.table("timing.csv", columns);
  const race::Pace fastest = race::fastest_pace(race_cells);
  for (const auto& race_cell : race_cells)
    if (!race_cell.laps.empty()) add_race_cell(table, study, race_cell, fastest);
  for (const auto mode : suite::keys_of<suite::TimingKeys>(study).modes)
    add_sentinel(table, study, race_cells, mode, fastest);
}

}  // namespace bezierbench::studies
