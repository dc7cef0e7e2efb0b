// SPDX-License-Identifier: MIT
// CSV as in RFC 4180, cut into records and fields. What the fields mean is for those who read them.
#pragma once

#include <cstddef>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace bezierbench {

/// A text that is not CSV, or not what its reader asks for; what() begins with `NAME:LINE: `.
class CsvFault : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// `text` as a field, quoted where required.
[[nodiscard]] std::string csv_field(std::string_view text);

/// `1 field`, `2 fields`.
[[nodiscard]] std::string count_of_fields(std::size_t count);

/// Cuts a text into a header and rows, one at a time. Lines are counted from 1 and are more than records where a quoted
/// field spans several. A byte order mark before the header is passed over.
class CsvRecords {
 public:
  /// `name` is the file's, for messages. The records and their fields refer to `text`.
  CsvRecords(std::string_view text, std::string name);

  [[nodiscard]] const std::string& name() const { return name_; }
  [[nodiscard]] bool done() const { return position_ == text_.size(); }
  /// What has not been read yet.
  [[nodiscard]] std::string_view rest() const { return text_.substr(position_); }
  /// The line at which the last record begins.
  [[nodiscard]] std::size_t line() const { return record_line_; }
  /// The fields of the last record; valid until the next one.
  [[nodiscard]] const std::vector<std::string_view>& fields() const { return fields_; }

  /// Throws CsvFault.
  [[noreturn]] void refuse(std::size_t line, std::string_view what) const;

  /// The first record. Throws CsvFault for an empty text, for control characters, and for a name
  /// that is empty or occurs twice.
  std::vector<std::string> header();
  /// The next record. Throws CsvFault unless it has as many fields as the header.
  void next_row();

 private:
  [[nodiscard]] char peek() const { return done() ? '\0' : text_[position_]; }
  void next();
  bool take_line_end();
  std::string_view plain();
  std::string_view quoted();

  std::string_view text_;
  std::string name_;
  std::size_t columns_ = 0;
  std::size_t position_ = 0;
  std::size_t line_ = 1;
  std::size_t record_line_ = 1;
  std::vector<std::string_view> fields_;
  std::vector<std::pair<std::size_t, std::string>> unquoted_;  ///< fields with doubled quotes
};

}  // namespace bezierbench
