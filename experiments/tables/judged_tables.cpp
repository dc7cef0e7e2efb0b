// SPDX-License-Identifier: MIT
#include "experiments/tables/judged_tables.hpp"

#include <utility>

#include "experiments/tables/cell_fields.hpp"

namespace bezierbench::tables {
namespace {

constexpr std::string_view unbounded = "unbounded_trials";

std::vector<std::string> cell_and_method(const TableRow& row) {
  std::vector<std::string> fields;
  for (const auto& column : cell_columns()) fields.push_back(row.text(column));
  return fields;
}

}  // namespace

JudgedTables::JudgedTables(std::vector<bundle::CsvDocument> accuracies,
                           const std::optional<bundle::CsvDocument>& reference)
    : accuracies_(std::move(accuracies)) {
  if (!reference || !reference->has_column(unbounded)) return;
  for (std::size_t at = 0; at < reference->row_count(); ++at)
    if (const TableRow row(*reference, at); row.optional_number(unbounded) == 0)
      all_bounded_.insert(cell_and_method(row));
}

void JudgedTables::each_row(const std::string& study, const std::function<void(const TableRow&)>& visit) const {
  for (const auto& table : accuracies_)
    for (std::size_t at = 0; at < table.row_count(); ++at) {
      const TableRow row(table, at);
      if (row.text("baseline") != "exact" || row.text("status") != "ok") continue;
      if (study.empty() || row.text("study") == study) visit(row);
    }
}

std::optional<double> JudgedTables::bound(const TableRow& row, std::string_view column) const {
  const bool all_bounded =
      row.has(unbounded) ? row.optional_number(unbounded) == 0 : all_bounded_.contains(cell_and_method(row));
  return all_bounded ? row.optional_number(column) : std::nullopt;
}

}  // namespace bezierbench::tables
