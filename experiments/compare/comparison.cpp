// SPDX-License-Identifier: MIT
#include "experiments/compare/comparison.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>

#include "experiments/tables/table_row.hpp"
#include "reference/number/number.hpp"

namespace bezierbench::compare {
namespace {

constexpr std::array<std::string_view, 3> qualities{"ok", "few_rounds", "unchecked"};  // best first

/// The columns with results that both tables have, the largest error first: digested, and not keys.
std::vector<std::string> result_columns(const bundle::DeclaredTable& declared, const bundle::CsvDocument& a,
                                        const bundle::CsvDocument& b) {
  std::vector<std::string> results;
  for (const auto& column : declared.columns)
    if (column.is_digested && !column.is_key && a.has_column(column.name) && b.has_column(column.name))
      results.push_back(column.name);
  std::stable_partition(results.begin(), results.end(), [](const auto& name) { return name.starts_with("max_error"); });
  return results;
}

/// What became of the mean and largest errors of row a in row b.
std::vector<std::pair<std::string, double>> errors_of(const bundle::DeclaredTable& declared, const tables::TableRow& a,
                                                      const tables::TableRow& b) {
  std::vector<std::pair<std::string, double>> errors;
  for (const auto& column : declared.columns) {
    const bool is_error = column.name.starts_with("mean_error") || column.name.starts_with("max_error");
    if (!column.is_digested || !is_error || !a.has(column.name) || !b.has(column.name)) continue;
    const auto before = a.optional_number(column.name);
    const auto after = b.optional_number(column.name);
    if (before && after && *after != *before)  // what has no number any more has a status
      errors.emplace_back(column.name, *before > 0 ? *after / *before : std::numeric_limits<double>::infinity());
  }
  return errors;
}

/// What row b says against the method and row a does not; empty where there is nothing.
std::string newly_broken(const bundle::DeclaredTable& declared, const tables::TableRow& a, const tables::TableRow& b) {
  const auto both_have = [&](std::string_view name) { return a.has(name) && b.has(name); };
  constexpr std::string_view ok = "ok";
  constexpr std::string_view refuted = "refuted";
  if (both_have("status") && a.text("status") == ok && b.text("status") != ok) return "status " + b.text("status");
  if (both_have("property") && a.text("verdict") != refuted && b.text("verdict") == refuted)
    return b.text("property") + " is refuted";
  for (const auto& column : declared.columns) {
    const bool is_lost = column.name == "non_finite";
    if (!column.is_number || (!is_lost && column.accuses.empty()) || !both_have(column.name)) continue;
    if (a.optional_number(column.name).value_or(0) == 0 && b.optional_number(column.name).value_or(0) > 0)
      return is_lost ? "results that are not finite" : column.accuses;
  }
  return "";
}

/// The ratio of two results; NaN where a is 0 or one of them is not a number.
double ratio_of_results(const std::string& a, const std::string& b) {
  const auto x = number::parse_number(a);
  const auto y = number::parse_number(b);
  return x && y && *x != 0 ? *y / *x : std::numeric_limits<double>::quiet_NaN();
}

void compare_results(const bundle::DeclaredTable& declared, const bundle::CsvDocument& a, const bundle::CsvDocument& b,
                     Comparison& comparison) {
  const auto columns = result_columns(declared, a, b);
  auto joined = join(declared, a, b);
  for (auto& pair : joined.pairs) {
    const auto differs = [&](const auto& name) { return !same_value(a.at(pair.a, name), b.at(pair.b, name)); };
    const auto found = std::ranges::find_if(columns, differs);
    Row row{declared.file, std::move(pair.inputs), columns.empty() ? "" : columns.front(), "", ""};
    if (found != columns.end()) row.column = *found;
    if (!columns.empty()) {
      row.a = a.at(pair.a, row.column);
      row.b = b.at(pair.b, row.column);
    }
    row.ratio.median = ratio_of_results(row.a, row.b);
    row.verdict = found == columns.end() ? identical : different;
    if (row.verdict == different) {
      const tables::TableRow row_a(a, pair.a);
      const tables::TableRow row_b(b, pair.b);
      row.errors = errors_of(declared, row_a, row_b);
      row.broken = newly_broken(declared, row_a, row_b);
    }
    comparison.results.push_back(std::move(row));
  }
  for (auto& inputs : joined.only_a) comparison.only_a.push_back({declared.file, std::move(inputs)});
  for (auto& inputs : joined.only_b) comparison.only_b.push_back({declared.file, std::move(inputs)});
}

void compare_all_results(Comparison& comparison) {
  const Side& a = *comparison.a;
  const Side& b = *comparison.b;
  if (a.manifest.seed != b.manifest.seed) return;
  const bool same_suite = a.manifest.suite_digest == b.manifest.suite_digest;
  for (const auto& declared : bundle::declared_tables()) {
    if (!declared.is_deterministic) continue;
    const auto& ours = a.table(declared.file);
    const auto& theirs = b.table(declared.file);
    const bool on_both = !ours.header().empty() && !theirs.header().empty();
    if (!same_suite && on_both && !ours.has_column("trials"))
      comparison.left_out.push_back(declared.file);
    else
      compare_results(declared, ours, theirs, comparison);
  }
}

metric::Interval time_of(const tables::TableRow& row) {
  return {row.number("median_ns"), row.number("low_ns"), row.number("high_ns")};
}

/// The time in units of the sentinel of the same races; empty in the sentinel's own row.
std::optional<metric::Interval> units_of(const tables::TableRow& row) {
  if (!row.optional_number("sentinel_units")) return std::nullopt;
  return metric::Interval{row.number("sentinel_units"), row.number("sentinel_units_low"),
                          row.number("sentinel_units_high")};
}

std::string_view quality_of(const tables::TableRow& row) {
  return row.text("checked") == "yes" ? std::string_view(row.text("quality")) : "unchecked";
}

/// The worse of two qualities. One that this program does not know is worse than every known one.
std::string worse(std::string_view a, std::string_view b) {
  return std::string(std::ranges::find(qualities, a) > std::ranges::find(qualities, b) ? a : b);
}

/// From the lower of the low ends to the higher of the high ends.
metric::Interval over_both(const metric::Interval& a, const metric::Interval& b) {
  return {a.median, std::min(a.low, b.low), std::max(a.high, b.high)};
}

void compare_times(Comparison& comparison) {
  const auto& a = comparison.a->table(timing_file);
  const auto& b = comparison.b->table(timing_file);
  auto joined = join(*bundle::declared_table(timing_file), a, b);
  for (auto& pair : joined.pairs) {
    const tables::TableRow row_a(a, pair.a);
    const tables::TableRow row_b(b, pair.b);
    Timed timed{time_of(row_a), time_of(row_b)};
    timed.quality = worse(quality_of(row_a), quality_of(row_b));
    const auto raw = ratio(timed.b, timed.a);
    if (const auto units_a = units_of(row_a), units_b = units_of(row_b); units_a && units_b)
      timed.normalised = ratio(*units_b, *units_a);
    timed.judged = !timed.normalised         ? raw
                   : comparison.same_machine ? over_both(raw, *timed.normalised)
                                             : *timed.normalised;
    const auto verdict = timed.quality == "ok" ? metric::verdict(timed.judged) : metric::Verdict::unresolved;
    comparison.times.push_back({timing_file, std::move(pair.inputs), "median_ns", number::decimal(timed.a.median),
                                number::decimal(timed.b.median), raw, metric::name(verdict), std::move(timed)});
  }
  for (auto& inputs : joined.only_a) comparison.only_a.push_back({timing_file, std::move(inputs)});
  for (auto& inputs : joined.only_b) comparison.only_b.push_back({timing_file, std::move(inputs)});
}

/// Counts are compared where the same compiler made both programs; they are equal or they are not.
void compare_costs(Comparison& comparison) {
  const auto& a = *comparison.a;
  const auto& b = *comparison.b;
  for (const auto* fact : {"build.compiler", "build.flags"})
    if (a.fact(fact) != b.fact(fact)) return;
  for (auto& pair : join(*bundle::declared_table(cost_file), a.table(cost_file), b.table(cost_file)).pairs) {
    const tables::TableRow row_a(a.table(cost_file), pair.a);
    const tables::TableRow row_b(b.table(cost_file), pair.b);
    constexpr const char* column = "instructions";
    Row row{cost_file, std::move(pair.inputs), column, row_a.text(column), row_b.text(column)};
    const double growth = row_b.number(column) / row_a.number(column);
    row.ratio = {growth, growth, growth};
    row.verdict = growth == 1 ? identical : different;
    comparison.costs.push_back(std::move(row));
  }
}

// The columns of comparison.csv; the contract lists `kind` and those of the first two arrays.
constexpr std::array<std::string_view, 6> leading_inputs{"study", "method", "scalar", "dimension", "degree", "mode"};
constexpr std::array<std::string_view, 6> results{"a", "b", "ratio", "ratio_low", "ratio_high", "verdict"};
constexpr std::array<std::string_view, 8> further_inputs{"table", "form",      "coordinate_range", "t_min",
                                                         "t_max", "generator", "trials",           "baseline"};
constexpr std::array<std::string_view, 10> explanations{"against", "bundle",     "file",           "column",
                                                        "quality", "normalised", "normalised_low", "normalised_high",
                                                        "rank_a",  "rank_b"};

std::vector<std::string> line_of(const Comparison& comparison, const Row& row) {
  std::vector<std::string> fields{row.timed ? "timing" : row.file == cost_file ? "cost" : "accuracy"};
  const auto number = [&](double value) { fields.push_back(std::isnan(value) ? "" : number::decimal(value)); };
  const auto add_interval = [&](const metric::Interval& ratio) {
    for (const double value : {ratio.median, ratio.low, ratio.high}) number(value);
  };
  for (const auto name : leading_inputs) fields.push_back(row.inputs.field(name));
  fields.insert(fields.end(), {row.a, row.b});
  add_interval(row.ratio);
  fields.emplace_back(row.verdict);
  for (const auto name : further_inputs) fields.push_back(row.inputs.field(name));
  fields.insert(fields.end(), {comparison.a->name, comparison.b->name, row.file, row.column});
  const auto timed = row.timed.value_or(Timed{});
  fields.push_back(timed.quality);
  add_interval(timed.normalised.value_or(Row().ratio));
  for (const int rank : {timed.rank_a, timed.rank_b}) fields.push_back(rank == 0 ? "" : std::to_string(rank));
  return fields;
}

}  // namespace

double Row::growth() const {
  const double ratio_of_sizes = std::abs(ratio.median);
  return std::isnan(ratio_of_sizes) ? std::numeric_limits<double>::infinity() : ratio_of_sizes;
}

std::vector<const Row*> Comparison::differing() const {
  std::vector<const Row*> rows;
  for (const auto& row : results)
    if (row.verdict == different) rows.push_back(&row);
  std::ranges::stable_sort(rows, std::greater(), &Row::growth);
  return rows;
}

Comparison compare_sides(const Side& a, const Side& b) {
  Comparison comparison{&a, &b, same_machine(a, b)};
  compare_all_results(comparison);
  compare_times(comparison);
  compare_costs(comparison);
  return comparison;
}

std::string recorded_input(const Side& side, const Inputs& inputs) {
  const auto& table = side.table("worst.csv");
  for (std::size_t row = 0; row < table.row_count(); ++row) {
    const Inputs recorded(*bundle::declared_table("worst.csv"), table, row, table);
    const auto agrees = [&](std::string_view name) { return recorded.field(name) == inputs.field(name); };
    if (std::ranges::all_of(std::array{"study", "form", "method", "scalar", "dimension", "degree", "coordinate_range",
                                       "t_min", "t_max", "generator"},
                            agrees))
      return table.at(row, "worst_id");
  }
  return "";
}

bundle::CsvTable comparison_table(const std::vector<Comparison>& comparisons) {
  std::vector<std::string> columns{"kind"};
  columns.insert(columns.end(), leading_inputs.begin(), leading_inputs.end());
  columns.insert(columns.end(), results.begin(), results.end());
  columns.insert(columns.end(), further_inputs.begin(), further_inputs.end());
  columns.insert(columns.end(), explanations.begin(), explanations.end());
  bundle::CsvTable table(columns);
  for (const auto& comparison : comparisons)
    for (const auto* rows : {&comparison.results, &comparison.times, &comparison.costs})
      for (const auto& row : *rows) table.add_row(line_of(comparison, row));
  return table;
}

}  // namespace bezierbench::compare
