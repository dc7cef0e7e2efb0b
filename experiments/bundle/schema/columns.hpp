// SPDX-License-Identifier: MIT
// The tables of a bundle and their columns, as tables.schema.json declares them: there is no other list.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace bezierbench::bundle {

struct Column {
  std::string name;
  bool is_key = false;       ///< one of the columns that identify a row
  bool is_number = false;    ///< every field is a number or empty; else fields are text
  bool is_digested = false;  ///< part of the table's digests
  /// What a count above 0, or a `no`, says against a row, for `verify`; empty where it does not matter.
  std::string accuses = {};
  bool is_of_promise = false;   ///< only methods for which methods.csv states a bound or a promise
  bool is_of_external = false;  ///< and external methods
};

struct DeclaredTable {
  std::string file;
  bool is_deterministic = false;  ///< suite and seed determine every bit of it
  std::string study;              ///< name of the column with the study of a row
  std::string method;             ///< name of the column with the method of a row; empty without one
  std::vector<Column> columns;    ///< in the order of the file
  /// The columns in which a count above 0 speaks against a method that is to be chosen; empty where none can be chosen.
  std::vector<std::string> faults = {};
  std::string within_tolerance = {};  ///< name of the column that must not exceed the tolerance; empty without one
  std::string measure = {};           ///< name of the first column that figures show; empty without one
  std::string measure_words = {};     ///< what it is, with its unit

  /// The column of this name; null where none is declared.
  [[nodiscard]] const Column* column(std::string_view name) const;
  /// The names of the columns, in their order.
  [[nodiscard]] std::vector<std::string> header() const;
  /// The names of the columns that are digested, in their order.
  [[nodiscard]] std::vector<std::string> digested() const;
};

/// All tables, in the order of the schema.
[[nodiscard]] const std::vector<DeclaredTable>& declared_tables();

/// The table of this file name; null for a file that is not a table of a bundle.
[[nodiscard]] const DeclaredTable* declared_table(std::string_view file);

/// The schema version of the bundles that this program writes and reads.
[[nodiscard]] int written_version();

/// The last commit whose program reads bundles of earlier schema versions.
[[nodiscard]] std::string last_reader_of_earlier();

}  // namespace bezierbench::bundle
