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
  /// Failure(input_output) for a table that lacks a column.
  void each_row(const std::string& study, const std::function<void(const TableRow&)>& visit) const;

 private:
  std::vector<bundle::CsvDocument> read_;
  const Tables* made_ = nullptr;
};

/// The field of a row in `column`, `bound_u` or `max_bound`. Empty where a trial of the row has no bound, since the field
/// then covers only the others.
std::optional<double> bound(const TableRow& row, std::string_view column);

}  // namespace bezierbench::tables
