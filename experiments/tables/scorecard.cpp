// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <optional>

#include "experiments/metric/order_statistics.hpp"
#include "experiments/suite/kind.hpp"
#include "experiments/suite/suite.hpp"
#include "experiments/tables/tables.hpp"
#include "reference/number/number.hpp"
#include "reference/published/published.hpp"

namespace bezierbench::tables {
namespace {

constexpr std::string_view time_statistic = "total_time";
constexpr double clock_quantum_ms = 1;  ///< the report reads a clock of whole milliseconds

/// One line of a published file.
struct PrintedCell {
  std::string table, form, method, statistic, degree, note;
  double coordinate_range = 0;
  std::optional<suite::Interval> t_interval;
  double value = 0;
  suite::Interval rounded;  ///< the values that are printed as this one
  std::optional<suite::Interval>
      corrected;  ///< of the value probably meant, where the printed one breaks its row's pattern
};

double number(const std::string& text) { return number::parse_number(text).value(); }

/// The values that are rounded to `text`, to half a unit of its last digit; `text` is digits[.digits][eEXPONENT].
suite::Interval rounded_to(const std::string& text) {
  const std::size_t exponent_at = std::min(text.find('e'), text.size());
  std::string digits = text.substr(0, exponent_at);
  std::int64_t exponent = exponent_at < text.size() ? number::parse_integer(text.substr(exponent_at + 1)).value() : 0;
  if (const std::size_t point = digits.find('.'); point != std::string::npos) {
    exponent -= static_cast<std::int64_t>(digits.size() - point - 1);
    digits.erase(point, 1);
  }
  const std::int64_t tenths = 10 * number::parse_integer(digits).value();
  return {number(fmt::format("{}e{}", tenths - 5, exponent - 1)),
          number(fmt::format("{}e{}", tenths + 5, exponent - 1))};
}

std::vector<PrintedCell> printed_cells(const std::string& file_name) {
  std::vector<PrintedCell> cells;
  for (const auto& table : reference::published_tables()) {
    if (table.file_name != file_name) continue;
    const auto csv = bundle::parse_csv(table.text, table.file_name);
    for (std::size_t row = 0; row < csv.row_count(); ++row) {
      PrintedCell cell{.table = csv.at(row, "table"),
                       .form = csv.at(row, "form"),
                       .method = csv.at(row, "path"),
                       .statistic = csv.at(row, "statistic"),
                       .degree = csv.at(row, "degree"),
                       .note = csv.at(row, "note"),
                       .coordinate_range = number(csv.at(row, "coordinate_range")),
                       .t_interval = std::nullopt,
                       .value = number(csv.at(row, "value")),
                       .rounded = {},
                       .corrected = std::nullopt};
      const bool counted = cell.statistic.starts_with("count_");
      cell.rounded = counted ? suite::Interval{cell.value, cell.value} : rounded_to(csv.at(row, "value"));
      if (const auto& meant = csv.at(row, "corrected"); !meant.empty()) cell.corrected = rounded_to(meant);
      if (!csv.at(row, "t_min").empty())
        cell.t_interval = suite::Interval{number(csv.at(row, "t_min")), number(csv.at(row, "t_max"))};
      cells.push_back(std::move(cell));
    }
  }
  return cells;
}

bool reproduces(const suite::Study& study, const PrintedCell& cell) {
  return (study.id == cell.table || study.id.starts_with(cell.table + "-")) && name(study.form) == cell.form;
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
std::optional<double> median(const Series* series) {
  return series == nullptr ? std::nullopt : std::optional(median(*series));
}

/// A row of `scorecard.csv` or `scorecard_timing.csv` with the fields of the printed cell.
Row row_of(std::string_view file, const PrintedCell& cell) {
  Row row(file);
  row.set("table", cell.table)
      .set("form", cell.form)
      .set("method", cell.method)
      .set("statistic", cell.statistic)
      .set("degree", cell.degree)
      .set("coordinate_range", cell.coordinate_range)
      .set("published", cell.value);
  if (cell.t_interval) row.set("t_min", cell.t_interval->min).set("t_max", cell.t_interval->max);
  return row;
}

Row& set_not_in_suite(Row& row) { return row.set("verdict", "outside").set("note", "not in this suite"); }

/// An edge of the band, a quantile of the repetitions, and the values between which the quantile of the experiment
/// lies; infinite where the repetitions are too few to say.
struct Edge {
  double value, low, high;
};

/// Where the middle 90 % of honest repetitions lie, as far as ours tell.
struct Band {
  static constexpr unsigned long part = 20;         ///< edges are the quantiles 1/20 and 19/20
  static constexpr unsigned long exceptions = 200;  ///< they lie between their limits with 99 %

  Band(std::vector<double> ours, const metric::Ranks& ranks)
      : low{.value = metric::quantile(ours, 1.0 / part), .low = -infinity, .high = infinity},
        high{.value = metric::quantile(ours, 1 - 1.0 / part), .low = -infinity, .high = infinity},
        chance_outside(2 * static_cast<double>(ranks.low) / static_cast<double>(ours.size() + 1)) {
    std::ranges::sort(ours);
    if (ranks.low > 0) {
      low.low = ours[ranks.low - 1];
      high.high = ours[ours.size() - ranks.low];
    }
    if (ranks.high <= ours.size()) {
      low.high = ours[ranks.high - 1];
      high.low = ours[ours.size() - ranks.high];
    }
  }

  /// Of a printed value, each of the values that are rounded to it considered.
  [[nodiscard]] std::string_view verdict(const suite::Interval& printed) const {
    if (low.high <= printed.min && printed.max <= high.low) return "inside";
    return printed.max < low.low || high.high < printed.min ? "outside" : "edge";
  }

  Edge low, high;
  /// The probability that one more repetition lies outside: it takes each place among ours with the same probability.
  double chance_outside;

 private:
  static constexpr double infinity = std::numeric_limits<double>::infinity();
};

/// By the number of repetitions; made once, since the integers grow with it.
using RanksOfEdges = std::map<std::size_t, metric::Ranks>;

const metric::Ranks& ranks_of_edges(std::size_t count, RanksOfEdges& known) {
  const auto found = known.find(count);
  if (found != known.end()) return found->second;
  return known.emplace(count, metric::quantile_ranks(count, Band::part, Band::exceptions)).first->second;
}

std::string_view accuracy_verdict(const PrintedCell& cell, const Band& band) {
  const std::string_view verdict = band.verdict(cell.rounded);
  const bool explained = verdict == "outside" && cell.corrected && band.verdict(*cell.corrected) != "outside";
  return explained ? "explained" : verdict;
}

void set_edge(Row& row, const std::string& column, const Edge& edge) {
  row.set("ours_" + column, edge.value);
  if (std::isfinite(edge.low)) row.set(column + "_low", edge.low);
  if (std::isfinite(edge.high)) row.set(column + "_high", edge.high);
}

void write_accuracy_cell(const suite::Study& study, const PrintedCell& cell, std::span<const Series> series,
                         RanksOfEdges& ranks, Tables& tables) {
  const std::string& baseline = study.baseline.front();
  const auto* ours = find(series, study, cell, study.generator.front(), baseline, "");
  Row row = row_of("scorecard.csv", cell);
  if (ours == nullptr || ours->values.empty()) {
    set_not_in_suite(row);
  } else {
    const Band band(ours->values, ranks_of_edges(ours->values.size(), ranks));
    set_edge(row, "p05", band.low);
    set_edge(row, "p95", band.high);
    row.set("ours_median", median(*ours))
        .set("continuous_median", median(find(series, study, cell, "continuous", baseline, "")))
        .set("against_exact", median(find(series, study, cell, study.generator.front(), "exact", "")))
        .set("chance_outside", band.chance_outside)
        .set("verdict", accuracy_verdict(cell, band))
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
    if (const auto file = study.published; !file.empty() && std::ranges::find(files, file) == files.end())
      files.emplace_back(file);
  RanksOfEdges ranks;
  for (const auto& file : files)
    for (const auto& cell : printed_cells(file))
      for (const auto& study : studies) {
        if (study.published != file || !reproduces(study, cell)) continue;
        if (cell.statistic == time_statistic)
          write_timing_cell(study, cell, series, tables);
        else
          write_accuracy_cell(study, cell, series, ranks, tables);
        break;  // one row per printed cell
      }
}

}  // namespace bezierbench::tables
