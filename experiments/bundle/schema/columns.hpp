// SPDX-License-Identifier: MIT
// The tables of a bundle and their columns, as tables.schema.json declares them: there is no other list.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace bezierbench::bundle {

struct Column {
  std::string name;
  bool is_key = false;         ///< one of the columns that identify a row
  bool is_number = false;      ///< every field is a number or empty; else fields are text
  bool is_digested = false;    ///< part of the table's digests
  bool is_deprecated = false;  ///< written by earlier programs only
  int since = 1;               ///< first schema version in which it is digested
};

struct DeclaredTable {
  std::string file;
  bool is_deterministic = false;  ///< suite and seed determine every bit of it
  std::string study;              ///< name of the column with the study of a row
  std::string method;             ///< name of the column with the method of a row; empty without one
  std::vector<Column> columns;    ///< in the order of the file

  /// The column of this name; null where none is declared.
  [[nodiscard]] const Column* column(std::string_view name) const;
  /// The columns that are written, in their order.
  [[nodiscard]] std::vector<std::string> header() const;
  /// The names of the columns that a bundle of this schema version digests, in their order.
  [[nodiscard]] std::vector<std::string> digested(int version) const;
};

/// All tables, in the order of the schema.
[[nodiscard]] const std::vector<DeclaredTable>& declared_tables();

/// The table of this file name; null for a file that is not a table of a bundle.
[[nodiscard]] const DeclaredTable* declared_table(std::string_view file);

/// The schema version of the bundles that this program writes. It reads bundles of every version from 1 on.
[[nodiscard]] int written_version();

}  // namespace bezierbench::bundle
