// SPDX-License-Identifier: MIT
#include "experiments/compare/accuracy.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>

#include "experiments/bundle/schema/columns.hpp"
#include "experiments/number/number.hpp"

namespace bezierbench::compare {
namespace {

/// The columns with results that both tables have: digested, and not keys.
std::vector<std::string> result_columns(const bundle::DeclaredTable& declared, const bundle::CsvDocument& a,
                                        const bundle::CsvDocument& b) {
  std::vector<std::string> results;
  for (const auto& column : declared.columns)
    if (column.is_digested && !column.is_key && a.has_column(column.name) && b.has_column(column.name))
      results.push_back(column.name);
  return results;
}

AccuracyRow compare_rows(const bundle::CsvDocument& a, const bundle::CsvDocument& b, const RowPair& pair,
                         const std::vector<std::string>& results) {
  const auto has = [&](const std::string& column) { return std::ranges::find(results, column) != results.end(); };
  const auto result = [&](const std::string& column) -> ResultPair {
    return {column, has(column) ? a.at(pair.a, column) : "", has(column) ? b.at(pair.b, column) : ""};
  };
  const auto differs = [&](const std::string& column) {
    return !same_value(a.at(pair.a, column), b.at(pair.b, column));
  };
  AccuracyRow row{{}, pair.inputs, true, {}, {}, a.line(pair.a), b.line(pair.b)};
  if (const auto first = std::ranges::find_if(results, differs); first != results.end()) {
    row.identical = false;
    row.first = result(*first);
  } else {
    row.first = result(has("max_error") || results.empty() ? "max_error" : results.front());
  }
  row.shown = row.first;
  const std::string largest = has("max_error_u") ? "max_error_u" : "max_error";
  if (has(largest) && differs(largest)) row.shown = result(largest);
  return row;
}

void compare_table(const bundle::DeclaredTable& declared, const bundle::CsvDocument& a, const bundle::CsvDocument& b,
                   AccuracyComparison& comparison) {
  std::map<bundle::Rows, RowCounts> of_no_method;
  auto& methods = declared.study.empty() || declared.method.empty() ? of_no_method : comparison.methods;
  const auto counts = [&](const Inputs& inputs) -> RowCounts& {
    const auto study = declared.study.empty() ? "" : inputs.field(declared.study);
    return methods[{declared.file, study, inputs.field("method")}];
  };
  const auto results = result_columns(declared, a, b);
  const auto match = match_rows(declared, a, b);
  for (const auto& pair : match.pairs) {
    auto& row = comparison.rows.emplace_back(compare_rows(a, b, pair, results));
    row.file = declared.file;
    ++counts(row.inputs).pairs;
    counts(row.inputs).differing += row.identical ? 0 : 1;
  }
  for (const auto& inputs : match.only_a) ++counts(inputs).only_a;
  for (const auto& inputs : match.only_b) ++counts(inputs).only_b;
  comparison.only_a += match.only_a.size();
  comparison.only_b += match.only_b.size();
}

}  // namespace

double AccuracyRow::growth() const {
  const auto x = number::parse_number(shown.a);
  const auto y = number::parse_number(shown.b);
  const double ratio = x && y ? std::abs(*y) / std::abs(*x) : std::numeric_limits<double>::quiet_NaN();
  return std::isnan(ratio) ? std::numeric_limits<double>::infinity() : ratio;
}

std::size_t AccuracyComparison::differing() const {
  return static_cast<std::size_t>(std::ranges::count(rows, false, &AccuracyRow::identical));
}

AccuracyComparison compare_accuracy(const Side& a, const Side& b) {
  AccuracyComparison comparison;
  const bool same_seed = a.manifest.seed == b.manifest.seed;
  const bool same_suite = a.manifest.suite_digest == b.manifest.suite_digest;
  for (const auto& declared : bundle::declared_tables()) {
    if (!declared.is_deterministic) continue;
    static const bundle::CsvDocument no_rows{};
    const auto* ours = a.table(declared.file);
    const auto* theirs = b.table(declared.file);
    const auto& table_a = ours != nullptr ? *ours : no_rows;
    const auto& table_b = theirs != nullptr ? *theirs : no_rows;
    if (!same_seed) {
      comparison.only_a += table_a.row_count();
      comparison.only_b += table_b.row_count();
    } else if (!same_suite && ours != nullptr && theirs != nullptr && !ours->has_column("trials")) {
      comparison.left_out.push_back(declared.file);
      AccuracyComparison rows;  // those that are equal agree; others may be about different numbers of trials
      compare_table(declared, table_a, table_b, rows);
      for (auto& [of, count] : rows.methods) {
        count.only_a += count.differing;
        count.differing = 0;
        comparison.methods.emplace(of, count);
      }
    } else {
      compare_table(declared, table_a, table_b, comparison);
    }
  }
  return comparison;
}

std::vector<MethodChange> method_changes(const AccuracyComparison& accuracy) {
  std::map<std::string, MethodChange> methods;
  for (const auto& row : accuracy.rows) {
    auto& change = methods[row.inputs.field("method")];
    change.method = row.inputs.field("method");
    ++change.rows;
    if (!row.identical) change.differing.push_back(&row);
  }
  std::vector<MethodChange> changes;
  for (auto& [method, change] : methods) {
    if (change.differing.empty()) continue;
    std::ranges::stable_sort(change.differing, std::greater(), &AccuracyRow::growth);
    changes.push_back(std::move(change));
  }
  std::ranges::stable_sort(changes, std::greater(),
                           [](const MethodChange& change) { return change.differing.front()->growth(); });
  return changes;
}

std::string recorded_input(const Side& side, const Inputs& inputs) {
  constexpr std::array<std::string_view, 10> cell{
      "study", "form", "method", "scalar", "dimension", "degree", "coordinate_range", "t_min", "t_max", "generator"};
  const auto* table = side.table("worst.csv");
  for (std::size_t row = 0; table != nullptr && row < table->row_count(); ++row) {
    const Inputs recorded(*bundle::declared_table("worst.csv"), *table, row, *table);
    if (std::ranges::all_of(cell, [&](auto column) { return recorded.field(column) == inputs.field(column); }))
      return table->at(row, "worst_id");
  }
  return "";
}

}  // namespace bezierbench::compare
