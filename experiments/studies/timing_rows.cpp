// SPDX-License-Identifier: MIT
#include "experiments/studies/timing_rows.hpp"

#include <algorithm>

#include "experiments/metric/order_statistics.hpp"
#include "experiments/metric/verdict.hpp"
#include "experiments/number/number.hpp"
#include "experiments/studies/cell_fields.hpp"
#include "experiments/suite/names.hpp"

namespace bezierbench::studies {
namespace {

constexpr std::string_view ok = "ok";
constexpr std::string_view noisy = "noisy";

std::string_view quality(const Heat& heat, const HeatLap& lap, const Pace& fastest) {
  return drifted(heat.laps, fastest) || sittings_disagree(lap) ? noisy : ok;
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

/// relative_to, ratio, ratio_low, ratio_high: over sittings, of each of which the ratio is taken round by round.
std::vector<std::string> ratio_fields(const Heat& heat, const HeatLap& lap, std::optional<std::size_t> base) {
  if (!base) return {"", "", "", ""};
  auto fields = interval_fields(timing::sitting_ratios(lap.sittings, heat.laps[*base].sittings));
  fields.insert(fields.begin(), std::string(heat.methods[*base]->id));
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
  std::vector<std::string> inputs;  ///< coordinate_range to generator
  std::vector<std::string> units;   ///< sentinel_units to sentinel_units_high
  std::vector<std::string> asked;   ///< order to data
  Pace pace;                        ///< sentinel_ns, sweep_ns
};

void add_row(bundle::CsvTable& table, RowParts parts, const HeatLap& lap) {
  const auto rounds = lap.rounds();
  auto row = std::move(parts.key);
  const auto append = [&](const std::vector<std::string>& more) { row.insert(row.end(), more.begin(), more.end()); };
  append(interval_fields(lap.sitting_ns()));
  append({std::to_string(rounds.ns_per_point.size()), std::to_string(rounds.points_per_round)});
  append(parts.ratio);
  append({median_text(rounds.cycles_per_point), median_text(rounds.instructions_per_point), std::string(parts.quality),
          rounds.checked ? "yes" : "no"});
  append(parts.inputs);
  append({std::to_string(lap.sittings.size())});
  append(parts.units);
  append(parts.asked);
  append({number::decimal(parts.pace.chain_ns), number::decimal(parts.pace.sweep_ns)});
  table.add_row(std::move(row));
}

void add_heat(bundle::CsvTable& table, const suite::Study& study, const Heat& heat, const Pace& fastest) {
  const auto base = relative_to(heat, study);
  const auto beside = pace(heat.laps);
  for (std::size_t m = 0; m < heat.methods.size(); ++m)
    add_row(table,
            {.key = {study.id, std::string(suite::name(study.curve)), std::string(heat.methods[m]->id),
                     std::string(suite::name(heat.scalar)), std::to_string(heat.cell.dimension),
                     std::to_string(heat.cell.degree), std::string(suite::name(heat.mode))},
             .ratio = ratio_fields(heat, heat.laps[m], base),
             .quality = quality(heat, heat.laps[m], fastest),
             .inputs = drawn_fields(heat.cell),
             .units = interval_fields(quotients(heat.laps[m].sitting_ns(), heat.laps.back().sitting_ns())),
             .asked = asked_fields(heat.asked),
             .pace = beside},
            heat.laps[m]);
}

/// The sentinel over all heats of a mode.
void add_sentinel(bundle::CsvTable& table, const suite::Study& study, const std::vector<Heat>& heats, suite::Mode mode,
                  const Pace& fastest) {
  HeatLaps all;
  std::string_view worst = ok;
  for (const auto& heat : heats) {
    if (heat.mode != mode || heat.laps.empty()) continue;
    all.merge({{heat.laps.end() - 2, heat.laps.end()}});
    if (drifted(heat.laps, fastest)) worst = noisy;
  }
  if (all.each.empty()) return;
  add_row(table,
          {.key = {study.id, std::string(suite::name(study.curve)), std::string(timing::sentinel_name),
                   std::string(suite::name(suite::ScalarKind::float64)), "", "", std::string(suite::name(mode))},
           .ratio = {"", "", "", ""},
           .quality = worst,
           .inputs = {"", "", "", ""},
           .units = {"", "", ""},
           .asked = asked_fields({}),
           .pace = pace(all.each)},
          all.each.back());
}

}  // namespace

void write_timing_rows(const suite::Study& study, const std::vector<Heat>& heats, Tables& tables) {
  std::vector<std::string> columns{
      "study",     "curve",      "method",  "scalar",       "dimension",        "degree",      "mode",
      "median_ns", "low_ns",     "high_ns", "rounds",       "points_per_round", "relative_to", "ratio",
      "ratio_low", "ratio_high", "cycles",  "instructions", "quality",          "checked"};
  columns.insert(columns.end(), drawn_columns().begin(), drawn_columns().end());
  columns.insert(columns.end(), {"sittings", "sentinel_units", "sentinel_units_low", "sentinel_units_high"});
  columns.insert(columns.end(), asked_columns().begin(), asked_columns().end());
  columns.insert(columns.end(), {"sentinel_ns", "sweep_ns"});
  auto& table = tables.table("timing.csv", columns);
  const Pace fastest = fastest_pace(heats);
  for (const auto& heat : heats)
    if (!heat.laps.empty()) add_heat(table, study, heat, fastest);
  for (const auto mode : study.modes) add_sentinel(table, study, heats, mode, fastest);
}

}  // namespace bezierbench::studies
