// SPDX-License-Identifier: MIT
// One line of a table that was read, field by field.
#pragma once

#include <fmt/format.h>

#include <optional>
#include <string>
#include <string_view>

#include "experiments/bundle/csv.hpp"
#include "experiments/failure.hpp"
#include "experiments/number/number.hpp"

namespace bezierbench::tables {

/// One row of a table; the table must outlive it.
class TableRow {
 public:
  TableRow(const bundle::CsvDocument& table, std::size_t row) : table_(table), row_(row) {}

  [[nodiscard]] bool has(std::string_view column) const { return table_.has_column(column); }
  /// Throws Failure(input_output) for a column that the table does not have.
  [[nodiscard]] const std::string& text(std::string_view column) const { return table_.at(row_, column); }
  /// The number in a field. Throws Failure(input_output) as text() does, and for a field that is not a number.
  [[nodiscard]] double number(std::string_view column) const {
    if (const auto value = number::parse_number(text(column))) return *value;
    throw Failure(Exit::input_output, fmt::format("{}:{}: {} is not a number; run the suite again", table_.file_name(),
                                                  table_.line(row_), column));
  }
  /// The number in a field; empty for an empty field, and for a column that an older version did not write.
  [[nodiscard]] std::optional<double> optional_number(std::string_view column) const {
    if (!has(column) || text(column).empty()) return std::nullopt;
    return number(column);
  }

 private:
  const bundle::CsvDocument& table_;
  std::size_t row_;
};

}  // namespace bezierbench::tables
