// SPDX-License-Identifier: MIT
#include "experiments/compare/accuracy.hpp"

#include <algorithm>
#include <array>

#include "experiments/bundle/digest.hpp"

namespace bezierbench::compare {
namespace {

constexpr const char* worst_file = "worst.csv";

/// What a row without a difference is shown by.
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
  return {file,           pair.inputs,   found == results.end(), column, field(a, pair.a), field(b, pair.b),
          a.line(pair.a), b.line(pair.b)};
}

}  // namespace

const AccuracyRow* AccuracyComparison::first_difference() const {
  const auto found = std::ranges::find(rows, false, &AccuracyRow::identical);
  return found == rows.end() ? nullptr : &*found;
}

AccuracyComparison compare_accuracy(const Side& a, const Side& b) {
  AccuracyComparison comparison;
  const bool same_suite = a.manifest.suite_digest == b.manifest.suite_digest;
  for (const auto name : bundle::deterministic_files) {
    const std::string file(name);
    const auto* ours = a.table(file);
    const auto* theirs = b.table(file);
    if (ours == nullptr && theirs == nullptr) continue;
    if (ours == nullptr || theirs == nullptr || a.manifest.seed != b.manifest.seed) {
      comparison.only_a += ours == nullptr ? 0 : ours->row_count();
      comparison.only_b += theirs == nullptr ? 0 : theirs->row_count();
      continue;
    }
    if (!same_suite && !ours->has_column("trials")) {
      comparison.left_out.push_back(file);
      continue;
    }
    const auto match = match_rows(*ours, *theirs);
    const auto results = result_columns(*ours, *theirs);
    for (const auto& pair : match.pairs) comparison.rows.push_back(compare_pair(file, pair, results, *ours, *theirs));
    comparison.only_a += match.only_a;
    comparison.only_b += match.only_b;
  }
  comparison.differing = static_cast<std::size_t>(std::ranges::count(comparison.rows, false, &AccuracyRow::identical));
  return comparison;
}

std::optional<RecordedInput> recorded_input(const Side& side, const Inputs& inputs) {
  constexpr std::array<std::string_view, 10> cell{
      "study", "curve", "method", "scalar", "dimension", "degree", "coordinate_range", "t_min", "t_max", "generator"};
  const auto* table = side.table(worst_file);
  for (std::size_t row = 0; table != nullptr && row < table->row_count(); ++row) {
    const Inputs recorded(*table, row, *table);
    if (std::ranges::all_of(cell, [&](auto column) { return recorded.field(column) == inputs.field(column); }))
      return RecordedInput{table->at(row, "worst_id"), table->at(row, "trial"), table->at(row, "t"),
                           table->at(row, "coefficients")};
  }
  return std::nullopt;
}

}  // namespace bezierbench::compare
