// SPDX-License-Identifier: MIT
// The tables of a bundle while they are filled, and the series that the scorecard compares with printed cells.
#pragma once

#include <compare>
#include <concepts>
#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "experiments/bundle/csv.hpp"
#include "experiments/bundle/digest.hpp"
#include "experiments/bundle/schema/columns.hpp"
#include "experiments/metric/counts.hpp"
#include "experiments/sample/cell.hpp"
#include "experiments/suite/suite.hpp"

namespace bezierbench::tables {

/// A number that is written in hexadecimal floating point, which keeps all bits.
struct Hexadecimal {
  double value;
  friend auto operator<=>(const Hexadecimal&, const Hexadecimal&) = default;
};

/// Nothing, a text, or a number.
using Field = std::variant<std::monostate, std::string, double, std::int64_t, Hexadecimal>;

/// The field of a text, a number, an optional one, or a field itself. No number and the empty text give the empty
/// field.
template <class Value>
Field field(const Value& value) {
  if constexpr (std::convertible_to<const Value&, std::string_view>) {
    const std::string_view text = value;
    return text.empty() ? Field() : Field(std::string(text));
  } else if constexpr (std::integral<Value>) {
    return static_cast<std::int64_t>(value);
  } else if constexpr (std::floating_point<Value>) {
    return static_cast<double>(value);
  } else if constexpr (requires { value.has_value(); }) {
    return value ? field(*value) : Field();
  } else {
    return value;
  }
}

/// The field as it stands in a file: doubles as the shortest decimals that give them back.
std::string text(const Field& field);

/// A row of a table, with one field for each column that the schema declares. Fields are set in any order; those that
/// are not set are empty.
class Row {
 public:
  /// A row of the table `file`. Throws std::logic_error for a table that the schema does not declare.
  explicit Row(std::string_view file);

  /// Sets a field to what tables::field() makes of the value. Throws std::logic_error for a column that the schema does
  /// not declare, and for a field that has a value already.
  template <class Value>
  Row& set(std::string_view column, const Value& value) {
    return put(column, tables::field(value));
  }
  /// Sets each of `columns` to the value at the same place.
  template <class Value>
  Row& set_each(const std::vector<std::string>& columns, const std::vector<Value>& values) {
    for (std::size_t k = 0; k < columns.size(); ++k) set(columns[k], values.at(k));
    return *this;
  }
  /// Replaces the value of a field. Throws std::logic_error for a column that the schema does not declare.
  void replace(std::string_view column, Field value) { fields_[place(column)] = std::move(value); }

  [[nodiscard]] const std::string& file() const { return table_->file; }
  /// Throws std::logic_error for a column that the schema does not declare.
  [[nodiscard]] const Field& field(std::string_view column) const { return fields_[place(column)]; }
  /// The texts of all fields, in the order of DeclaredTable::header().
  [[nodiscard]] std::vector<std::string> texts() const;

 private:
  Row& put(std::string_view column, Field value);
  [[nodiscard]] std::size_t place(std::string_view column) const;

  const bundle::DeclaredTable* table_;
  std::vector<Field> fields_;  ///< in the order of the declared columns
};

/// A table as text, with the digests of its rows.
struct WrittenTable {
  std::string text;                           ///< the bytes of the file
  std::vector<bundle::MethodDigest> digests;  ///< none of a table that is not deterministic
};

/// The rows of a file of a bundle.
class Table {
 public:
  explicit Table(const bundle::DeclaredTable& declared) : declared_(declared) {}

  void add(Row row) { rows_.push_back(std::move(row)); }
  [[nodiscard]] std::vector<Row>& rows() { return rows_; }
  [[nodiscard]] const std::vector<Row>& rows() const { return rows_; }
  [[nodiscard]] std::size_t row_count() const { return rows_.size(); }

  [[nodiscard]] WrittenTable written() const;
  /// The bytes of the file alone.
  [[nodiscard]] std::string text() const;

 private:
  const bundle::DeclaredTable& declared_;
  std::vector<Row> rows_;
};

/// The tables of a bundle, by file name.
class Tables {
 public:
  /// The table of this name, created at the first call. Throws std::logic_error for a table that the schema does not
  /// declare.
  Table& table(std::string_view file);
  void add(Row row) { table(row.file()).add(std::move(row)); }
  /// Null where no row of this table was added.
  [[nodiscard]] const Table* find(std::string_view file) const;
  [[nodiscard]] const std::map<std::string, Table, std::less<>>& all() const { return tables_; }

 private:
  std::map<std::string, Table, std::less<>> tables_;
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

/// Appends to `scorecard.csv` and `scorecard_timing.csv` one row per printed cell of the tables that these studies
/// reproduce. A study reproduces table X of its `published` file when its id is X or starts with "X-"; the first entry
/// of its `generator` and of its `baseline` are the report's own.
void write_scorecards(std::span<const suite::Study> studies, std::span<const Series> series, Tables& tables);

/// Completes the rows of `timing.csv` that have `max_error_u`, from all accuracy studies in the other tables:
/// `allowed_error_u` by metric::allowed_error_u(), and `checked` is `no` where it is exceeded.
void check_timed_errors(Tables& tables);

// The columns and fields of a row that identify its cell, and fields of statistics and counts.

/// study,form,method,scalar,dimension,degree,coordinate_range,t_min,t_max,generator,curves
const std::vector<std::string>& cell_columns();

/// The fields of cell_columns().
std::vector<Field> cell_fields(const suite::Study& study, const sample::Cell& cell, std::string_view method,
                               suite::ScalarKind scalar);

/// coordinate_range,t_min,t_max,generator,curves: how the inputs of a cell were drawn, or which curve set they are
/// from; then the generator is the placement of its curves. These are the last of cell_columns().
const std::vector<std::string>& drawn_columns();

/// The fields of drawn_columns().
std::vector<Field> drawn_fields(const sample::Cell& cell);

/// The fields of cell_columns() without the method, as text for a message.
std::string describe(const suite::Study& study, const sample::Cell& cell, suite::ScalarKind scalar);

using Statistic = double (*)(const metric::Tally&);
inline constexpr Statistic mean = [](const metric::Tally& tally) { return tally.mean(); };
inline constexpr Statistic root_mean_square = [](const metric::Tally& tally) { return tally.root_mean_square(); };
inline constexpr Statistic median = [](const metric::Tally& tally) { return tally.quantile(0.5); };
inline constexpr Statistic p99 = [](const metric::Tally& tally) { return tally.quantile(0.99); };
inline constexpr Statistic largest = [](const metric::Tally& tally) { return tally.max(); };

/// The statistic as a field; empty where no trial was tallied.
inline Field field(const metric::Tally& tally, Statistic which) {
  return tally.count() > 0 ? Field(which(tally)) : Field();
}

inline Field field(const metric::TrialCount& trials) { return field(trials.count); }
inline Field field(const metric::Largest<double>& most) { return most.value; }

}  // namespace bezierbench::tables
