// SPDX-License-Identifier: MIT
#include "experiments/tables/judged_tables.hpp"

namespace bezierbench::tables {

void JudgedTables::each_row(const std::string& study, const std::function<void(const TableRow&)>& visit) const {
  const auto visit_judged = [&](const std::vector<TableRow>& rows) {
    for (const TableRow& row : rows)
      if (row.text("baseline") == "exact" && row.text("status") == "ok" &&
          (study.empty() || row.text("study") == study))
        visit(row);
  };
  for (const auto& table : read_) visit_judged(rows_of(table));
  if (made_ == nullptr) return;
  for (const auto* file : {"accuracy.csv", "unstable.csv"})
    if (const auto* table = made_->find(file)) visit_judged(rows_of(*table));
}

std::optional<double> bound(const TableRow& row, std::string_view column) {
  return row.optional_number("unbounded_trials") == 0 ? row.optional_number(column) : std::nullopt;
}

}  // namespace bezierbench::tables
