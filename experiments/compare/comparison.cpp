// SPDX-License-Identifier: MIT
#include "experiments/compare/comparison.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>

#include "experiments/compare/ratio.hpp"
#include "experiments/tables/table_row.hpp"
#include "reference/number/number.hpp"

namespace bezierbench::compare {
namespace {

constexpr std::array<std::string_view, 4> qualities{"ok", "noisy", "few_rounds", "unchecked"};  // best first

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
    row.ratio.value.median = ratio_of_results(row.a, row.b);
    row.ratio.verdict = found == columns.end() ? identical : different;
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

/// Whether the times of fixed work (sentinel or sweep) beside these two rows differ by more than the tolerated drift.
/// On the same machine with the same build this means that the machine was disturbed or ran at another speed, so that a
/// difference between the rows does not concern the methods.
bool machine_changed(const tables::TableRow& ours, const tables::TableRow& theirs) {
  return std::ranges::any_of(std::array{"sentinel_ns", "sweep_ns"}, [&](std::string_view column) {
    const auto a = ours.optional_number(column);
    const auto b = theirs.optional_number(column);
    return a && b && std::max(*a, *b) > (1 + metric::tolerated_drift) * std::min(*a, *b);
  });
}

/// Whether the sentinels of both sides are the same machine code on the same machine: another compiler or other flags
/// may make a sentinel faster or slower.
bool same_sentinels(const Side& a, const Side& b) {
  return same_machine(a, b) && a.fact("build.compiler") == b.fact("build.compiler") &&
         a.fact("build.flags") == b.fact("build.flags");
}

Ratio ratio_of_times(const metric::Interval& b, const metric::Interval& a, std::string_view quality) {
  const auto value = ratio(b, a);
  return {value, metric::name(quality == "few_rounds" ? metric::Verdict::unresolved : metric::verdict(value))};
}

void compare_times(Comparison& comparison) {
  const auto& a = comparison.a->table(timing_file);
  const auto& b = comparison.b->table(timing_file);
  const bool fixed_work_compares = same_sentinels(*comparison.a, *comparison.b);
  auto joined = join(*bundle::declared_table(timing_file), a, b);
  for (auto& pair : joined.pairs) {
    const tables::TableRow row_a(a, pair.a);
    const tables::TableRow row_b(b, pair.b);
    Timed timed{time_of(row_a), time_of(row_b)};
    timed.quality = worse(quality_of(row_a), quality_of(row_b));
    if (fixed_work_compares && machine_changed(row_a, row_b)) timed.quality = worse(timed.quality, "noisy");
    const auto raw = ratio_of_times(timed.b, timed.a, timed.quality);
    if (const auto units_a = units_of(row_a), units_b = units_of(row_b); units_a && units_b)
      timed.normalised = ratio_of_times(*units_b, *units_a, timed.quality);
    comparison.times.push_back({timing_file, std::move(pair.inputs), "median_ns", number::decimal(timed.a.median),
                                number::decimal(timed.b.median), raw, std::move(timed)});
  }
  for (auto& inputs : joined.only_a) comparison.only_a.push_back({timing_file, std::move(inputs)});
  for (auto& inputs : joined.only_b) comparison.only_b.push_back({timing_file, std::move(inputs)});
}

// The columns of comparison.csv; the contract lists `kind` and those of the first two arrays.
constexpr std::array<std::string_view, 6> leading_inputs{"study", "method", "scalar", "dimension", "degree", "mode"};
constexpr std::array<std::string_view, 6> results{"a", "b", "ratio", "ratio_low", "ratio_high", "verdict"};
constexpr std::array<std::string_view, 8> further_inputs{"table", "form",      "coordinate_range", "t_min",
                                                         "t_max", "generator", "trials",           "baseline"};
constexpr std::array<std::string_view, 11> explanations{"against",        "bundle",          "file",
                                                        "column",         "quality",         "normalised",
                                                        "normalised_low", "normalised_high", "normalised_verdict",
                                                        "rank_a",         "rank_b"};

std::vector<std::string> line_of(const Comparison& comparison, const Row& row) {
  std::vector<std::string> fields{row.timed ? "timing" : "accuracy"};
  const auto number = [&](double value) { fields.push_back(std::isnan(value) ? "" : number::decimal(value)); };
  const auto add_ratio = [&](const Ratio& ratio) {
    for (const double value : {ratio.value.median, ratio.value.low, ratio.value.high}) number(value);
    fields.emplace_back(ratio.verdict);
  };
  for (const auto name : leading_inputs) fields.push_back(row.inputs.field(name));
  fields.insert(fields.end(), {row.a, row.b});
  add_ratio(row.ratio);
  for (const auto name : further_inputs) fields.push_back(row.inputs.field(name));
  fields.insert(fields.end(), {comparison.a->name, comparison.b->name, row.file, row.column});
  const auto timed = row.timed.value_or(Timed{});
  fields.push_back(timed.quality);
  add_ratio(timed.normalised.value_or(Ratio{}));
  for (const int rank : {timed.rank_a, timed.rank_b}) fields.push_back(rank == 0 ? "" : std::to_string(rank));
  return fields;
}

}  // namespace

double Row::growth() const {
  const double ratio_of_sizes = std::abs(ratio.value.median);
  return std::isnan(ratio_of_sizes) ? std::numeric_limits<double>::infinity() : ratio_of_sizes;
}

const Ratio& Row::judged(bool same_machine) const {
  return same_machine || !timed || !timed->normalised ? ratio : *timed->normalised;
}

bool Row::is_certainly_slower() const {
  const auto slower = [](const Ratio& of) { return of.verdict == metric::name(metric::Verdict::slower); };
  return timed && timed->quality == "ok" && slower(ratio) && timed->b.low > timed->a.high &&
         (!timed->normalised || slower(*timed->normalised));
}

std::vector<const Row*> Comparison::differing() const {
  std::vector<const Row*> rows;
  for (const auto& row : results)
    if (row.ratio.verdict == different) rows.push_back(&row);
  std::ranges::stable_sort(rows, std::greater(), &Row::growth);
  return rows;
}

Comparison compare_sides(const Side& a, const Side& b) {
  Comparison comparison{&a, &b, same_machine(a, b)};
  compare_all_results(comparison);
  compare_times(comparison);
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
    for (const auto* rows : {&comparison.results, &comparison.times})
      for (const auto& row : *rows) table.add_row(line_of(comparison, row));
  return table;
}

}  // namespace bezierbench::compare
