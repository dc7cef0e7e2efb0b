// SPDX-License-Identifier: MIT
// The tables of a bundle with the errors of its methods.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "experiments/tables/table_row.hpp"

namespace bezierbench::tables {

class JudgedTables {
 public:
  /// Of accuracy.csv and unstable.csv, as far as a bundle has them.
  explicit JudgedTables(std::vector<bundle::CsvDocument> read) : read_(std::move(read)) {}
  /// Of a run, whose tables must outlive it.
  explicit JudgedTables(const Tables& made) : made_(&made) {}

  /// Calls `visit` for every row with errors against the truth; only for those of `study`, if that is not empty. Throws
  /// Failure(input_output) for a table without a required column.
  void each_row(const std::string& study, const std::function<void(const TableRow&)>& visit) const {
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

 private:
  std::vector<bundle::CsvDocument> read_;
  const Tables* made_ = nullptr;
};

/// The field of a row in `column`, `bound_u` or `max_bound`. Empty where a trial of the row has no bound, since the field
/// then covers only the others.
inline std::optional<double> bound(const TableRow& row, std::string_view column) {
  return row.optional_number("unbounded_trials") == 0 ? row.optional_number(column) : std::nullopt;
}

}  // namespace bezierbench::tables
