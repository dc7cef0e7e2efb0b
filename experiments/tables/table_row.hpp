// SPDX-License-Identifier: MIT
// One row of a table, field by field, whether the table was read from a file or is about to be written; and the rows
// with the errors of methods.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
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
  /// A field as it is: a text where the table was read. Throws Failure(input_output) for a column that the file does
  /// not have, std::logic_error for one that the schema does not declare.
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
    throw Failure(Exit::input_output, "{}:{}: {} is not a number; run the suite again", read_->file_name(),
                  read_->line(number_), column);
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

/// The texts of these values, as the fields of a table have them.
template <class... Values>
std::vector<std::string> texts(const Values&... values) {
  return {text(field(values))...};
}

inline std::vector<TableRow> rows_of(const bundle::CsvDocument& table) {
  std::vector<TableRow> rows;
  for (std::size_t row = 0; row < table.row_count(); ++row) rows.emplace_back(table, row);
  return rows;
}

inline std::vector<TableRow> rows_of(const Table& table) { return {table.rows().begin(), table.rows().end()}; }

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

/// The field of a row in `column`, `bound_u` or `max_bound`. Empty where a trial of the row has no bound, since the
/// field then covers only the others.
inline std::optional<double> bound(const TableRow& row, std::string_view column) {
  return row.optional_number("unbounded_trials") == 0 ? row.optional_number(column) : std::nullopt;
}

}  // namespace bezierbench::tables
