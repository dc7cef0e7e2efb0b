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
  std::optional<double> corrected;  ///< the value probably meant, where the printed one breaks its row's pattern
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

/// A row of `scorecard.csv` or `scorecard_timing.csv` with the fields of the printed cell.
Row row_of(std::string_view file, const PrintedCell& cell) {
  Row row(file);
  row.set("table", cell.table)
      .set("curve", cell.curve)
      .set("method", cell.method)
      .set("statistic", cell.statistic)
      .set("degree", cell.degree)
      .set("coordinate_range", cell.coordinate_range)
      .set("published", cell.value);
  if (cell.t_interval) row.set("t_min", cell.t_interval->min).set("t_max", cell.t_interval->max);
  return row;
}

Row& set_not_in_suite(Row& row) { return row.set("verdict", "outside").set("note", "not in this suite"); }

void write_accuracy_cell(const suite::Study& study, const PrintedCell& cell, std::span<const Series> series,
                         Tables& tables) {
  const std::string& baseline = study.baseline.front();
  const auto* ours = find(series, study, cell, study.generator.front(), baseline, "");
  Row row = row_of("scorecard.csv", cell);
  if (ours == nullptr || ours->values.empty()) {
    set_not_in_suite(row);
  } else {
    const double low = metric::quantile(ours->values, 0.05);
    const double high = metric::quantile(ours->values, 0.95);
    const auto inside = [&](double value) { return low <= value && value <= high; };
    const std::string_view verdict = inside(cell.value)                          ? "inside"
                                     : cell.corrected && inside(*cell.corrected) ? "explained"
                                                                                 : "outside";
    row.set("ours_median", median(*ours))
        .set("ours_p05", low)
        .set("ours_p95", high)
        .set("continuous_median", median_text(find(series, study, cell, "continuous", baseline, "")))
        .set("against_exact", median_text(find(series, study, cell, study.generator.front(), "exact", "")))
        .set("verdict", verdict)
        .set("note", cell.note);
  }
  tables.add(row);
}

/// Whether the printed time is at most one step of its clock. Any machine that is fast enough meets such a time.
bool is_untestable(const PrintedCell& cell) { return cell.value <= clock_quantum_ms; }

/// Whether the clock of the source report may show the printed time for a time from `low` to `high`, in milliseconds.
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

/// Printed times are in milliseconds per 1000 curves, that is microseconds per curve; the series are in nanoseconds.
void write_timing_cell(const suite::Study& study, const PrintedCell& cell, std::span<const Series> series,
                       Tables& tables) {
  constexpr double ns_per_unit = 1000;
  const auto* ours = find(series, study, cell, study.generator.front(), "", "one_shot");
  const auto* prepared = find(series, study, cell, study.generator.front(), "", "point");
  Row row = row_of("scorecard_timing.csv", cell);
  if (ours == nullptr || ours->values.empty()) {
    set_not_in_suite(row);
  } else {
    const double low = metric::quantile(ours->values, 0.05) / ns_per_unit;
    const double high = metric::quantile(ours->values, 0.95) / ns_per_unit;
    row.set("ours_median", median(*ours) / ns_per_unit)
        .set("ours_p05", low)
        .set("ours_p95", high)
        .set("verdict", timing_verdict(cell, low, high))
        .set("note", timing_note(cell));
    if (prepared != nullptr) row.set("prepared_median", median(*prepared) / ns_per_unit);
  }
  tables.add(row);
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
