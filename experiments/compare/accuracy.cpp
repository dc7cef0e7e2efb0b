// SPDX-License-Identifier: MIT
#include "experiments/compare/accuracy.hpp"

#include <algorithm>
#include <array>
#include <map>
#include <set>

#include "experiments/bundle/schema/columns.hpp"

namespace bezierbench::compare {
namespace {

constexpr const char* worst_file = "worst.csv";

/// The column that is printed for a pair of identical rows: the largest error or, without one, the first result.
std::string shown(const std::vector<std::string>& results) {
  constexpr std::string_view largest = "max_error";
  const bool there = std::ranges::find(results, largest) != results.end();
  return there || results.empty() ? std::string(largest) : results.front();
}

AccuracyRow compare_pair(const std::string& file, const RowPair& pair, const std::vector<std::string>& results,
                         const bundle::CsvDocument& a, const bundle::CsvDocument& b) {
  const auto differs = [&](const auto& column) { return !same_value(a.at(pair.a, column), b.at(pair.b, column)); };
  const auto found = std::ranges::find_if(results, differs);
  const std::string column = found == results.end() ? shown(results) : *found;
  const auto field = [&](const auto& table, std::size_t row) {
    return table.has_column(column) ? table.at(row, column) : std::string();
  };
  AccuracyRow row{file,           pair.inputs,   found == results.end(), column, field(a, pair.a), field(b, pair.b),
                  a.line(pair.a), b.line(pair.b)};
  for (const std::string largest : {"max_error_u", "max_error"})
    if (!row.largest && std::ranges::find(results, largest) != results.end())
      row.largest = ResultPair{largest, a.at(pair.a, largest), b.at(pair.b, largest)};
  return row;
}

/// The columns that are digested and that both tables have.
std::vector<std::string> common_digested(const bundle::DeclaredTable& declared, const bundle::CsvDocument& a,
                                         const bundle::CsvDocument& b) {
  std::vector<std::string> columns;
  for (const auto& column : declared.columns)
    if (column.is_digested && a.has_column(column.name) && b.has_column(column.name)) columns.push_back(column.name);
  return columns;
}

/// The digest of the rows of each method in each study; empty for a table without columns of study and method.
std::map<bundle::Rows, std::string> digests_of(const bundle::DeclaredTable& declared, const bundle::CsvDocument* table,
                                               const std::vector<std::string>& columns) {
  std::map<bundle::Rows, std::string> digests;
  if (table == nullptr || !table->has_column(declared.study) || !table->has_column(declared.method)) return digests;
  for (auto& one : bundle::method_digests(declared, *table, columns)) digests.emplace(one.rows, one.digest);
  return digests;
}

/// Sorts the methods of both tables into `methods`. `differing` has those with a pair of rows whose results differ.
void compare_methods(const bundle::DeclaredTable& declared, const bundle::CsvDocument* a, const bundle::CsvDocument* b,
                     const std::set<bundle::Rows>& differing, MethodComparison& methods) {
  const bool both = a != nullptr && b != nullptr;
  const auto columns = both ? common_digested(declared, *a, *b) : std::vector<std::string>();
  const auto ours = digests_of(declared, a, columns);
  const auto theirs = digests_of(declared, b, columns);
  for (const auto& [rows, digest] : ours) {
    const auto found = theirs.find(rows);
    if (found == theirs.end())
      methods.only_a.push_back(rows);
    else if (differing.contains(rows))
      methods.differing.push_back(rows);
    else if (found->second == digest)
      methods.agreeing.push_back(rows);
    else
      methods.other_rows.push_back(rows);
  }
  for (const auto& [rows, digest] : theirs)
    if (!ours.contains(rows)) methods.only_b.push_back(rows);
}

void compare_table(const bundle::DeclaredTable& declared, const bundle::CsvDocument* a, const bundle::CsvDocument* b,
                   AccuracyComparison& comparison) {
  std::set<bundle::Rows> differing;
  if (a != nullptr && b != nullptr) {
    const auto match = match_rows(declared, *a, *b);
    const auto results = result_columns(declared, *a, *b);
    for (const auto& pair : match.pairs) {
      comparison.rows.push_back(compare_pair(declared.file, pair, results, *a, *b));
      if (!comparison.rows.back().identical)
        differing.insert({declared.file, pair.inputs.field(declared.study), pair.inputs.field("method")});
    }
    comparison.only_a += match.only_a;
    comparison.only_b += match.only_b;
  } else {
    comparison.only_a += a == nullptr ? 0 : a->row_count();
    comparison.only_b += b == nullptr ? 0 : b->row_count();
  }
  compare_methods(declared, a, b, differing, comparison.methods);
}

}  // namespace

AccuracyComparison compare_accuracy(const Side& a, const Side& b) {
  AccuracyComparison comparison;
  const bool same_suite = a.manifest.suite_digest == b.manifest.suite_digest;
  for (const auto& declared : bundle::declared_tables()) {
    if (!declared.is_deterministic) continue;
    const auto* ours = a.table(declared.file);
    const auto* theirs = b.table(declared.file);
    if (ours == nullptr && theirs == nullptr) continue;
    if (a.manifest.seed != b.manifest.seed) {
      comparison.only_a += ours == nullptr ? 0 : ours->row_count();
      comparison.only_b += theirs == nullptr ? 0 : theirs->row_count();
    } else if (!same_suite && ours != nullptr && theirs != nullptr && !ours->has_column("trials")) {
      comparison.left_out.push_back(declared.file);
      compare_methods(declared, ours, theirs, {}, comparison.methods);  // equal digests mean equal rows
    } else {
      compare_table(declared, ours, theirs, comparison);
    }
  }
  comparison.differing = static_cast<std::size_t>(std::ranges::count(comparison.rows, false, &AccuracyRow::identical));
  return comparison;
}

std::optional<RecordedInput> recorded_input(const Side& side, const Inputs& inputs) {
  constexpr std::array<std::string_view, 10> cell{
      "study", "curve", "method", "scalar", "dimension", "degree", "coordinate_range", "t_min", "t_max", "generator"};
  const auto* table = side.table(worst_file);
  for (std::size_t row = 0; table != nullptr && row < table->row_count(); ++row) {
    const Inputs recorded(*bundle::declared_table(worst_file), *table, row, *table);
    if (std::ranges::all_of(cell, [&](auto column) { return recorded.field(column) == inputs.field(column); }))
      return RecordedInput{table->at(row, "worst_id"), table->at(row, "trial"), table->at(row, "t"),
                           table->at(row, "coefficients")};
  }
  return std::nullopt;
}

}  // namespace bezierbench::compare
