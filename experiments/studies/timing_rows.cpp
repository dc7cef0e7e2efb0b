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
constexpr std::string_view few_rounds = "few_rounds";

std::string_view quality(const Heat& heat, double fastest) {
  if (!metric::covers_median(heat.laps.back().ns_per_point.size(), metric::timing_confidence)) return few_rounds;
  return drifted(heat.laps, fastest) ? noisy : ok;
}

std::vector<std::string> interval_fields(std::span<const double> sample) {
  const auto interval = metric::median_interval(sample, metric::timing_confidence);
  return {number::decimal(interval.median), number::decimal(interval.low), number::decimal(interval.high)};
}

/// relative_to, ratio, ratio_low, ratio_high: the ratio is taken round by round, in which both met the same machine.
std::vector<std::string> ratio_fields(const Heat& heat, const timing::Lap& lap, std::optional<std::size_t> base) {
  if (!base) return {"", "", "", ""};
  std::vector<double> ratios;
  for (std::size_t round = 0; round < lap.ns_per_point.size(); ++round)
    ratios.push_back(lap.ns_per_point[round] / heat.laps[*base].ns_per_point[round]);
  auto fields = interval_fields(ratios);
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
};

void add_row(bundle::CsvTable& table, RowParts parts, const timing::Lap& lap) {
  auto row = std::move(parts.key);
  const auto append = [&](const std::vector<std::string>& more) { row.insert(row.end(), more.begin(), more.end()); };
  append(interval_fields(lap.ns_per_point));
  append({std::to_string(lap.ns_per_point.size()), std::to_string(lap.points_per_round)});
  append(parts.ratio);
  append({median_text(lap.cycles_per_point), median_text(lap.instructions_per_point), std::string(parts.quality),
          lap.checked ? "yes" : "no"});
  append(parts.inputs);
  table.add_row(std::move(row));
}

void add_heat(bundle::CsvTable& table, const suite::Study& study, const Heat& heat, double fastest) {
  const auto base = relative_to(heat, study);
  for (std::size_t m = 0; m < heat.methods.size(); ++m)
    add_row(table,
            {.key = {study.id, std::string(suite::name(study.curve)), std::string(heat.methods[m]->id),
                     std::string(suite::name(heat.scalar)), std::to_string(heat.cell.dimension),
                     std::to_string(heat.cell.degree), std::string(suite::name(heat.mode))},
             .ratio = ratio_fields(heat, heat.laps[m], base),
             .quality = quality(heat, fastest),
             .inputs = drawn_fields(heat.cell)},
            heat.laps[m]);
}

void append(std::vector<double>& all, const std::vector<double>& more) {
  all.insert(all.end(), more.begin(), more.end());
}

/// The sentinel over all heats of a mode.
void add_sentinel(bundle::CsvTable& table, const suite::Study& study, const std::vector<Heat>& heats, suite::Mode mode,
                  double fastest) {
  timing::Lap all;
  std::string_view worst = ok;
  for (const auto& heat : heats) {
    if (heat.mode != mode || heat.laps.empty()) continue;
    const timing::Lap& lap = heat.laps.back();
    append(all.ns_per_point, lap.ns_per_point);
    append(all.cycles_per_point, lap.cycles_per_point);
    append(all.instructions_per_point, lap.instructions_per_point);
    all.points_per_round = std::max(all.points_per_round, lap.points_per_round);
    all.checked = all.checked && lap.checked;
    if (drifted(heat.laps, fastest)) worst = noisy;
  }
  if (all.ns_per_point.empty()) return;
  add_row(table,
          {.key = {study.id, std::string(suite::name(study.curve)), std::string(timing::sentinel_name),
                   std::string(suite::name(suite::ScalarKind::float64)), "", "", std::string(suite::name(mode))},
           .ratio = {"", "", "", ""},
           .quality = worst,
           .inputs = {"", "", "", ""}},
          all);
}

}  // namespace

void write_timing_rows(const suite::Study& study, const std::vector<Heat>& heats, Tables& tables) {
  std::vector<std::string> columns{
      "study",     "curve",      "method",  "scalar",       "dimension",        "degree",      "mode",
      "median_ns", "low_ns",     "high_ns", "rounds",       "points_per_round", "relative_to", "ratio",
      "ratio_low", "ratio_high", "cycles",  "instructions", "quality",          "checked"};
  columns.insert(columns.end(), drawn_columns().begin(), drawn_columns().end());
  auto& table = tables.table("timing.csv", columns);
  const double fastest = fastest_sentinel(heats);
  for (const auto& heat : heats)
    if (!heat.laps.empty()) add_heat(table, study, heat, fastest);
  for (const auto mode : study.modes) add_sentinel(table, study, heats, mode, fastest);
}

}  // namespace bezierbench::studies
