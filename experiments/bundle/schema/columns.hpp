// SPDX-License-Identifier: MIT
// The tables of a bundle and their columns, as tables.schema.json declares them: there is no other list.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace bezierbench::bundle {

struct Column {
  std::string name;
  bool is_key = false;         ///< says what a row is about
  bool is_number = false;      ///< every field is a number or empty; else fields are text
  bool is_digested = false;    ///< is in the digests of its table
  bool is_deprecated = false;  ///< in bundles of earlier programs only: no longer written
  int since = 1;               ///< the schema version of a bundle from which on it is digested
};

struct DeclaredTable {
  std::string file;
  bool is_deterministic = false;  ///< suite and seed determine every bit of it
  std::string study;              ///< name of the column that says of which study a row is
  std::string method;             ///< name of the column that says of which method a row is; empty without one
  std::vector<Column> columns;    ///< in the order in which they stand in the file

  /// Null for a name that is not declared.
  [[nodiscard]] const Column* column(std::string_view name) const;
  /// The columns that are written, in their order.
  [[nodiscard]] std::vector<std::string> header() const;
  /// The columns that the digests of a bundle of this schema version are of, in their order.
  [[nodiscard]] std::vector<std::string> digested(int version) const;
};

/// In the order of the schema.
[[nodiscard]] const std::vector<DeclaredTable>& declared_tables();

/// Null for a file that is no table of a bundle.
[[nodiscard]] const DeclaredTable* declared_table(std::string_view file);

/// The schema version of the bundles that this program writes. It reads those of all versions from 1 on.
[[nodiscard]] int written_version();

}  // namespace bezierbench::bundle
