// SPDX-License-Identifier: MIT
// One row of a table, field by field, whether the table was read from a file or is about to be written.
#pragma once

#include <fmt/format.h>

#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "experiments/bundle/csv.hpp"
#include "experiments/failure.hpp"
#include "experiments/tables/tables.hpp"
#include "reference/number/number.hpp"

namespace bezierbench::tables {

/// The table must outlive it.
class TableRow {
 public:
  TableRow(const bundle::CsvDocument& table, std::size_t row) : read_(&table), number_(row) {}
  explicit TableRow(const Row& row) : made_(&row) {}

  [[nodiscard]] bool has(std::string_view column) const { return made_ != nullptr || read_->has_column(column); }
  /// A field as it is: a text where the table was read. Throws Failure(input_output) for a column that the file does not
  /// have, std::logic_error for one that the schema does not declare.
  [[nodiscard]] Field field(std::string_view column) const {
    return made_ != nullptr ? made_->field(column) : tables::field(read_->at(number_, column));
  }
  /// A field of a column of words. Throws as field().
  [[nodiscard]] const std::string& text(std::string_view column) const {
    static const std::string empty;
    if (made_ == nullptr) return read_->at(number_, column);
    const Field& field = made_->field(column);
    return field == Field() ? empty : std::get<std::string>(field);
  }
  /// The number in a field. Throws as field(), and Failure(input_output) for a field that is not a number.
  [[nodiscard]] double number(std::string_view column) const {
    if (made_ != nullptr) {
      const Field& field = made_->field(column);
      const auto* integer = std::get_if<std::int64_t>(&field);
      return integer != nullptr ? static_cast<double>(*integer) : std::get<double>(field);
    }
    if (const auto value = number::parse_number(read_->at(number_, column))) return *value;
    throw Failure(Exit::input_output, fmt::format("{}:{}: {} is not a number; run the suite again", read_->file_name(),
                                                  read_->line(number_), column));
  }
  /// The number in a field; empty for an empty field, and for a column that an older program did not write.
  [[nodiscard]] std::optional<double> optional_number(std::string_view column) const {
    if (!has(column) || field(column) == Field()) return std::nullopt;
    return number(column);
  }

 private:
  const bundle::CsvDocument* read_ = nullptr;
  std::size_t number_ = 0;  ///< in `read_`
  const Row* made_ = nullptr;
};

inline std::vector<TableRow> rows_of(const bundle::CsvDocument& table) {
  std::vector<TableRow> rows;
  for (std::size_t row = 0; row < table.row_count(); ++row) rows.emplace_back(table, row);
  return rows;
}

inline std::vector<TableRow> rows_of(const Table& table) { return {table.rows().begin(), table.rows().end()}; }

}  // namespace bezierbench::tables
