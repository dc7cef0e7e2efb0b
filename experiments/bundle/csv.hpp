// SPDX-License-Identifier: MIT
// CSV as in RFC 4180, the format of every table of a bundle.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace bezierbench::bundle {

/// One line of a CSV file with its line end; fields are quoted only where required.
[[nodiscard]] std::string csv_line(const std::vector<std::string>& fields);

/// A table to write. Fields are text already: see number::decimal() and number::hexadecimal() for numbers.
class CsvTable {
 public:
  /// Throws std::invalid_argument without columns, for an empty or repeated name, or for a NUL byte.
  explicit CsvTable(std::vector<std::string> columns);

  /// Throws std::invalid_argument unless there is one field per column, none with a NUL byte.
  void add_row(std::vector<std::string> fields);

  [[nodiscard]] std::size_t row_count() const { return rows_.size(); }

  /// The header and the rows in the order in which they were added. Fields are quoted only where required, and every
  /// line ends with \n.
  [[nodiscard]] std::string text() const;

 private:
  std::vector<std::string> columns_;
  std::vector<std::vector<std::string>> rows_;
};

/// A table that was read: a header of distinct names, and rows that each have one field per name.
class CsvDocument {
 public:
  [[nodiscard]] const std::vector<std::string>& header() const { return header_; }
  [[nodiscard]] std::size_t row_count() const { return rows_.size(); }
  [[nodiscard]] bool has_column(std::string_view name) const;

  /// Index of the column `name`. Throws Failure(Exit::input_output), naming the file and the column, where there is
  /// none.
  [[nodiscard]] std::size_t column(std::string_view name) const;

  /// One field; `row` from 0, the header not counted. Throws as column(), and std::out_of_range for `row`.
  [[nodiscard]] const std::string& at(std::size_t row, std::string_view column_name) const;

  /// All fields of a row in the order of header(). Throws std::out_of_range.
  [[nodiscard]] const std::vector<std::string>& row(std::size_t row) const { return rows_.at(row); }

  /// The line, from 1, of the file at which the row begins: for messages. Throws std::out_of_range.
  [[nodiscard]] std::size_t line(std::size_t row) const { return lines_.at(row); }

  [[nodiscard]] const std::string& file_name() const { return file_name_; }

 private:
  friend CsvDocument parse_csv(std::string_view text, std::string_view file_name);

  std::string file_name_;
  std::vector<std::string> header_;
  std::vector<std::vector<std::string>> rows_;
  std::vector<std::size_t> lines_;
};

/// Parses a whole file. A byte order mark and CRLF are accepted; blanks belong to their field. Throws
/// Failure(Exit::input_output) with "FILE_NAME:LINE: ..." for an empty file, an empty or repeated column name, a row
/// with more or fewer fields than the header, a blank line, a misplaced or unterminated quote, a bare CR or
/// another control character.
[[nodiscard]] CsvDocument parse_csv(std::string_view text, std::string_view file_name);

}  // namespace bezierbench::bundle
