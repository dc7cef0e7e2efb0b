// SPDX-License-Identifier: MIT
#include "experiments/tables/scorecard.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>

#include "experiments/metric/order_statistics.hpp"
#include "experiments/number/number.hpp"
#include "experiments/suite/kinds.hpp"
#include "experiments/suite/names.hpp"
#include "reference/published/published.hpp"

namespace bezierbench::tables {
namespace {

constexpr std::string_view time_statistic = "total_time";
constexpr double clock_quantum_ms = 1;  ///< the report reads a clock of whole milliseconds

/// One line of a published file.
struct PrintedCell {
  std::string table, curve, method, statistic, degree, note;
  double coordinate_range = 0;
  std::optional<suite::Interval> t_interval;
  double value = 0;
  std::optional<double> corrected;  ///< what was probably meant, where the cell breaks the pattern of its row
};

double number(const std::string& text) { return number::parse_number(text).value(); }

std::vector<PrintedCell> printed_cells(const std::string& file_name) {
  std::vector<PrintedCell> cells;
  for (const auto& table : reference::published_tables()) {
    if (table.file_name != file_name) continue;
    const auto csv = bundle::parse_csv(table.text, table.file_name);
    for (std::size_t row = 0; row < csv.row_count(); ++row) {
      PrintedCell cell{.table = csv.at(row, "table"),
                       .curve = csv.at(row, "curve"),
                       .method = csv.at(row, "path"),
                       .statistic = csv.at(row, "statistic"),
                       .degree = csv.at(row, "degree"),
                       .note = csv.at(row, "note"),
                       .coordinate_range = number(csv.at(row, "coordinate_range")),
                       .t_interval = std::nullopt,
                       .value = number(csv.at(row, "value")),
                       .corrected = number::parse_number(csv.at(row, "corrected"))};
      if (!csv.at(row, "t_min").empty())
        cell.t_interval = suite::Interval{number(csv.at(row, "t_min")), number(csv.at(row, "t_max"))};
      cells.push_back(std::move(cell));
    }
  }
  return cells;
}

bool reproduces(const suite::Study& study, const PrintedCell& cell) {
  return (study.id == cell.table || study.id.starts_with(cell.table + "-")) && suite::name(study.curve) == cell.curve;
}

const Series* find(std::span<const Series> series, const suite::Study& study, const PrintedCell& cell,
                   std::string_view generator, std::string_view baseline, std::string_view mode) {
  for (const auto& one : series)
    if (one.study == study.id && one.method == cell.method && one.statistic == cell.statistic &&
        one.degree == cell.degree && one.coordinate_range == cell.coordinate_range &&
        (!cell.t_interval || !one.t_interval || *one.t_interval == *cell.t_interval) && one.generator == generator &&
        one.baseline == baseline && one.mode == mode)
      return &one;
  return nullptr;
}

double median(const Series& series) { return metric::quantile(series.values, 0.5); }
std::string median_text(const Series* series) { return series == nullptr ? "" : number::decimal(median(*series)); }

std::vector<std::string> leading_fields(const PrintedCell& cell) {
  return {cell.table,
          cell.curve,
          cell.method,
          cell.statistic,
          cell.degree,
          number::decimal(cell.coordinate_range),
          cell.t_interval ? number::decimal(cell.t_interval->min) : "",
          cell.t_interval ? number::decimal(cell.t_interval->max) : "",
          number::decimal(cell.value)};
}

const std::vector<std::string> columns{
    "table",   "curve",     "method",      "statistic", "degree",   "coordinate_range",  "t_min",
    "t_max",   "published", "ours_median", "ours_p05",  "ours_p95", "continuous_median", "against_exact",
    "verdict", "note"};

void write_accuracy_cell(const suite::Study& study, const PrintedCell& cell, std::span<const Series> series,
                         Tables& tables) {
  const std::string& baseline = study.baseline.front();
  const auto* ours = find(series, study, cell, study.generator.front(), baseline, "");
  auto fields = leading_fields(cell);
  if (ours == nullptr || ours->values.empty()) {
    fields.insert(fields.end(), {"", "", "", "", "", "outside", "not in this suite"});
  } else {
    const double low = metric::quantile(ours->values, 0.05);
    const double high = metric::quantile(ours->values, 0.95);
    const auto inside = [&](double value) { return low <= value && value <= high; };
    const std::string_view verdict = inside(cell.value)                          ? "inside"
                                     : cell.corrected && inside(*cell.corrected) ? "explained"
                                                                                 : "outside";
    fields.insert(fields.end(), {number::decimal(median(*ours)), number::decimal(low), number::decimal(high),
                                 median_text(find(series, study, cell, "continuous", baseline, "")),
                                 median_text(find(series, study, cell, study.generator.front(), "exact", "")),
                                 std::string(verdict), cell.note});
  }
  tables.table("scorecard.csv", columns).add_row(std::move(fields));
}

/// A time of no more than one step of its clock is met by every machine that is fast enough: it tests nothing.
bool is_untestable(const PrintedCell& cell) { return cell.value <= clock_quantum_ms; }

/// Whether the printed time is what that clock may show for a time from `low` to `high`, in milliseconds.
std::string_view timing_verdict(const PrintedCell& cell, double low, double high) {
  if (is_untestable(cell)) return "untestable";
  // A reading of k ms means k - 1 < time < k + 1.
  return low < cell.value + clock_quantum_ms && high > cell.value - clock_quantum_ms ? "inside" : "outside";
}

std::string timing_note(const PrintedCell& cell) {
  return fmt::format("{}; {}", cell.note,
                     is_untestable(cell) ? "no more than one step of the clock: every fast machine meets it"
                                         : "another machine, compiler and build");
}

/// Times in milliseconds per 1000 curves, which is microseconds per curve; the series are in nanoseconds.
void write_timing_cell(const suite::Study& study, const PrintedCell& cell, std::span<const Series> series,
                       Tables& tables) {
  constexpr double ns_per_unit = 1000;
  const auto* ours = find(series, study, cell, study.generator.front(), "", "one_shot");
  const auto* prepared = find(series, study, cell, study.generator.front(), "", "point");
  auto fields = leading_fields(cell);
  if (ours == nullptr || ours->values.empty()) {
    fields.insert(fields.end(), {"", "", "", "", "", "outside", "not in this suite", ""});
  } else {
    const double low = metric::quantile(ours->values, 0.05) / ns_per_unit;
    const double high = metric::quantile(ours->values, 0.95) / ns_per_unit;
    fields.insert(fields.end(),
                  {number::decimal(median(*ours) / ns_per_unit), number::decimal(low), number::decimal(high), "", "",
                   std::string(timing_verdict(cell, low, high)), timing_note(cell),
                   prepared == nullptr ? "" : number::decimal(median(*prepared) / ns_per_unit)});
  }
  auto timing_columns = columns;
  timing_columns.emplace_back("prepared_median");
  tables.table("scorecard_timing.csv", timing_columns).add_row(std::move(fields));
}

}  // namespace

void write_scorecards(std::span<const suite::Study> studies, std::span<const Series> series, Tables& tables) {
  std::vector<std::string> files;
  for (const auto& study : studies)
    if (const auto file = suite::published_of(study); !file.empty() && std::ranges::find(files, file) == files.end())
      files.emplace_back(file);
  for (const auto& file : files)
    for (const auto& cell : printed_cells(file))
      for (const auto& study : studies) {
        if (suite::published_of(study) != file || !reproduces(study, cell)) continue;
        if (cell.statistic == time_statistic)
          write_timing_cell(study, cell, series, tables);
        else
          write_accuracy_cell(study, cell, series, tables);
        break;  // one row per printed cell
      }
}

}  // namespace bezierbench::tables
