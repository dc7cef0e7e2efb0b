// SPDX-License-Identifier: MIT
// The tables of a bundle that say how wrong its methods are.
#pragma once

#include <functional>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "experiments/tables/table_row.hpp"

namespace bezierbench::tables {

class JudgedTables {
 public:
  /// Whoever has no such file leaves it out. Throws Failure(input_output) for a table without the columns.
  /// `accuracies` are accuracy.csv and unstable.csv; `reference` is reference.csv, which said in bundles of schema
  /// version 1 how many trials have no bound.
  JudgedTables(std::vector<bundle::CsvDocument> accuracies, const std::optional<bundle::CsvDocument>& reference);

  /// Every row with numbers against the truth; of one study only where `study` is not empty.
  void each_row(const std::string& study, const std::function<void(const TableRow&)>& visit) const;

  /// The field of a row, `bound_u` or `max_bound`. Empty where a trial of the row has no bound, for then the field
  /// speaks of the others only; empty, too, where nobody counted them, as in older bundles.
  [[nodiscard]] std::optional<double> bound(const TableRow& row, std::string_view column) const;

 private:
  std::vector<bundle::CsvDocument> accuracies_;
  std::set<std::vector<std::string>> all_bounded_;  ///< cells and methods of which reference.csv says so of all trials
};

}  // namespace bezierbench::tables
