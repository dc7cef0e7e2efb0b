// SPDX-License-Identifier: MIT
// The tables of a bundle while they are filled, and the series that the scorecard compares with printed cells.
#pragma once

#include <concepts>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "experiments/bundle/csv.hpp"
#include "experiments/bundle/schema/columns.hpp"
#include "experiments/number/number.hpp"
#include "experiments/suite/suite.hpp"

namespace bezierbench::tables {

/// A row to be written, field by field in any order. A field that is not set is empty.
class Row {
 public:
  /// A row of the table `file`. Throws std::logic_error for a table that the schema does not declare.
  explicit Row(std::string_view file);

  /// Sets a field. Throws std::logic_error for a column that the schema does not declare, and for one that was set
  /// before.
  Row& set(std::string_view column, std::string_view text);
  Row& set(std::string_view column, double number) { return set(column, number::decimal(number)); }
  template <std::integral Integer>
  Row& set(std::string_view column, Integer number) {
    return set(column, std::to_string(number));
  }
  /// Sets a field, to the empty text where there is no number.
  template <class Number>
  Row& set(std::string_view column, const std::optional<Number>& number) {
    return number ? set(column, *number) : set(column, "");
  }
  /// Sets each of `columns` to the field at the same place.
  Row& set_each(const std::vector<std::string>& columns, const std::vector<std::string>& fields);

  [[nodiscard]] const std::string& file() const { return table_.file; }
  /// All fields in the order of the schema's columns.
  [[nodiscard]] std::vector<std::string> fields() const;

 private:
  const bundle::DeclaredTable& table_;
  std::map<std::string, std::string, std::less<>> fields_;  ///< fields that were set, by column
};

/// The CSV files of a bundle while they are filled, by file name.
class Tables {
 public:
  /// The table of this name, created at the first call. Throws std::logic_error for a table that the schema does not
  /// declare.
  bundle::CsvTable& table(const std::string& file);
  void add(const Row& row) { table(row.file()).add_row(row.fields()); }
  [[nodiscard]] const std::map<std::string, bundle::CsvTable>& all() const { return tables_; }

 private:
  std::map<std::string, bundle::CsvTable> tables_;
};

/// One statistic of one cell, once per replicate: what a printed cell of a report is compared with.
struct Series {
  std::string study;
  std::string form;
  std::string method;
  std::string statistic;  ///< mean_error, max_error, count_within_1e-5, ..., total_time
  std::string degree;     ///< a number, or first..last for statistics over degrees
  double coordinate_range = 0;
  std::optional<suite::Interval> t_interval;
  std::string generator;
  std::string baseline;  ///< exact or a method id; empty for times
  std::string mode;      ///< of a timing; empty otherwise
  std::vector<double> values;
};

}  // namespace bezierbench::tables
