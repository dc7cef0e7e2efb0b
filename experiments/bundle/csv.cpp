// SPDX-License-Identifier: MIT
#include "experiments/bundle/csv.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>
#include <stdexcept>
#include <unordered_set>
#include <utility>

#include "experiments/failure.hpp"
#include "reference/number/echo.hpp"

namespace bezierbench::bundle {
namespace {

using Fields = std::vector<std::string>;

// The first repeated name, or nullptr.
const std::string* repeated(const Fields& names) {
  std::unordered_set<std::string_view> seen;
  for (const std::string& name : names) {
    if (!seen.insert(name).second) return &name;
  }
  return nullptr;
}

bool has_nul(const Fields& fields) {
  return std::ranges::any_of(fields, [](const std::string& field) { return field.find('\0') != std::string::npos; });
}

void append_field(std::string& text, const std::string& field, bool alone) {
  // A lone empty field would make a blank line, which readers skip.
  const bool quoted = field.find_first_of(",\"\r\n") != std::string::npos || (alone && field.empty());
  if (!quoted) {
    text += field;
    return;
  }
  text += '"';
  for (const char c : field) {
    if (c == '"') text += '"';
    text += c;
  }
  text += '"';
}

// Cuts a text into records and keeps count of lines, which are more than records where a quoted field spans several.
class Reader {
 public:
  Reader(std::string_view text, std::string_view file_name) : text_(text), file_name_(file_name) {}

  [[nodiscard]] bool done() const { return position_ == text_.size(); }
  [[nodiscard]] std::size_t line() const { return line_; }

  [[noreturn]] void fail(std::size_t line, std::string_view what) const {
    throw Failure(Exit::input_output, fmt::format("{}:{}: {}", file_name_, line, what));
  }

  Fields record() {
    if (take_line_end()) fail(line_ - 1, "blank line; remove it");
    Fields fields;
    for (;;) {
      fields.push_back(peek() == '"' && !done() ? quoted() : plain());
      if (done() || take_line_end()) return fields;
      if (peek() != ',') fail(line_, "text after a closing quote; put the whole field in quotes, inner quotes doubled");
      ++position_;
    }
  }

 private:
  [[nodiscard]] char peek() const { return done() ? '\0' : text_[position_]; }

  bool take_line_end() {
    const std::string_view rest = text_.substr(position_);
    const std::size_t length = rest.starts_with("\r\n") ? 2 : (rest.starts_with('\n') ? 1 : 0);
    position_ += length;
    line_ += length > 0;
    return length > 0;
  }

  std::string plain() {
    const std::size_t end = std::min(text_.find_first_of(",\r\n\"", position_), text_.size());
    std::string field(text_.substr(position_, end - position_));
    position_ = end;
    if (peek() == '"') fail(line_, "quote inside a field; put the whole field in quotes, inner quotes doubled");
    if (peek() == '\r' && !text_.substr(position_).starts_with("\r\n")) {
      fail(line_, "carriage return without a line feed; end lines with \\n or \\r\\n");
    }
    return field;
  }

  std::string quoted() {
    const std::size_t first_line = line_;
    std::string field;
    ++position_;
    for (;;) {
      const std::size_t quote = text_.find('"', position_);
      if (quote == std::string_view::npos) fail(first_line, "quote is never closed; close it or restore the file");
      const std::string_view part = text_.substr(position_, quote - position_);
      line_ += static_cast<std::size_t>(std::ranges::count(part, '\n'));
      field += part;
      position_ = quote + 1;
      if (peek() != '"') return field;
      field += '"';
      ++position_;
    }
  }

  std::string_view text_;
  std::string_view file_name_;
  std::size_t position_ = 0;
  std::size_t line_ = 1;
};

std::string count_of_fields(std::size_t count) { return fmt::format("{} {}", count, count == 1 ? "field" : "fields"); }

}  // namespace

std::string csv_line(const Fields& fields) {
  std::string line;
  for (std::size_t i = 0; i < fields.size(); ++i) {
    if (i > 0) line += ',';
    append_field(line, fields[i], fields.size() == 1);
  }
  return line + '\n';
}

CsvTable::CsvTable(std::vector<std::string> columns) : columns_(std::move(columns)) {
  const bool nameless = columns_.empty() || std::ranges::find(columns_, "") != columns_.end();
  if (nameless || repeated(columns_) || has_nul(columns_)) {
    throw std::invalid_argument("a CSV table needs distinct column names");
  }
}

void CsvTable::add_row(std::vector<std::string> fields) {
  if (fields.size() != columns_.size() || has_nul(fields)) {
    throw std::invalid_argument(
        fmt::format("a row of {} for {} columns, or a NUL byte", count_of_fields(fields.size()), columns_.size()));
  }
  rows_.push_back(std::move(fields));
}

std::string CsvTable::text() const {
  std::string text = csv_line(columns_);
  for (const Fields& row : rows_) text += csv_line(row);
  return text;
}

CsvDocument::CsvDocument(std::string file_name, std::vector<std::string> header,
                         std::vector<std::vector<std::string>> rows)
    : file_name_(std::move(file_name)), header_(std::move(header)), rows_(std::move(rows)), lines_(rows_.size()) {
  std::iota(lines_.begin(), lines_.end(), 2);
}

bool CsvDocument::has_column(std::string_view name) const { return std::ranges::find(header_, name) != header_.end(); }

std::size_t CsvDocument::column(std::string_view name) const {
  const auto found = std::ranges::find(header_, name);
  if (found == header_.end()) {
    throw Failure(Exit::input_output,
                  fmt::format("{}:1: no column '{}'; check that this is the right file", file_name_, name));
  }
  return static_cast<std::size_t>(found - header_.begin());
}

const std::string& CsvDocument::at(std::size_t row, std::string_view column_name) const {
  return rows_.at(row)[column(column_name)];
}

CsvDocument parse_csv(std::string_view text, std::string_view file_name) {
  if (text.starts_with("\xEF\xBB\xBF")) text.remove_prefix(3);
  Reader reader(text, file_name);
  if (text.empty()) reader.fail(1, "file is empty; it needs a header that names the columns");
  // A field goes to a terminal as it is where a command prints a table, so it must not be able to act on one.
  if (const std::size_t at = first_unprintable(text); at != std::string_view::npos) {
    const auto line = 1 + std::ranges::count(text.substr(0, at), '\n');
    reader.fail(static_cast<std::size_t>(line),
                fmt::format("character {}, which is not text; the file is damaged or not CSV: restore it",
                            printable(text.substr(at, 1))));
  }

  CsvDocument document;
  document.file_name_ = file_name;
  document.header_ = reader.record();
  const Fields& header = document.header_;
  if (std::ranges::find(header, "") != header.end()) reader.fail(1, "a column has no name; name every column");
  if (const std::string* name = repeated(header)) {
    reader.fail(1, fmt::format("column '{}' occurs twice; keep one", *name));
  }
  while (!reader.done()) {
    const std::size_t line = reader.line();
    Fields fields = reader.record();
    if (fields.size() != header.size()) {
      reader.fail(line, fmt::format("row has {}, the header has {}; add or remove fields, or restore the file",
                                    count_of_fields(fields.size()), header.size()));
    }
    document.rows_.push_back(std::move(fields));
    document.lines_.push_back(line);
  }
  return document;
}

}  // namespace bezierbench::bundle
