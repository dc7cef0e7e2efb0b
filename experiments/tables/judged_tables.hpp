// SPDX-License-Identifier: MIT
// The tables of a bundle with the errors of its methods.
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
  /// `accuracies` are accuracy.csv and unstable.csv, as far as the bundle has them. `reference` is reference.csv, which
  /// in bundles of schema version 1 has the number of trials without a bound. Throws Failure(input_output) for a table
  /// that lacks a column.
  JudgedTables(std::vector<bundle::CsvDocument> accuracies, const std::optional<bundle::CsvDocument>& reference);

  /// Calls `visit` for every row with errors against the truth; only for those of `study`, if that is not empty.
  void each_row(const std::string& study, const std::function<void(const TableRow&)>& visit) const;

  /// The field of a row in `column`, `bound_u` or `max_bound`. Empty where a trial of the row has no bound, since the
  /// field then covers only the others. Also empty where these trials were not counted, as in older bundles.
  [[nodiscard]] std::optional<double> bound(const TableRow& row, std::string_view column) const;

 private:
  std::vector<bundle::CsvDocument> accuracies_;
  std::set<std::vector<std::string>> all_bounded_;  ///< cells and methods all of whose trials have a bound
};

}  // namespace bezierbench::tables
