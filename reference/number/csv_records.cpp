// SPDX-License-Identifier: MIT
#include "reference/number/csv_records.hpp"

#include <algorithm>
#include <unordered_set>

#include "reference/number/echo.hpp"

namespace bezierbench {

std::string count_of_fields(std::size_t count) { return std::to_string(count) + (count == 1 ? " field" : " fields"); }

std::string csv_field(std::string_view text) {
  if (text.find_first_of(",\"\r\n") == std::string_view::npos) return std::string(text);
  std::string field = "\"";
  for (const char c : text) {
    if (c == '"') field += '"';
    field += c;
  }
  return field + '"';
}

CsvRecords::CsvRecords(std::string_view text, std::string name) : text_(text), name_(std::move(name)) {
  if (text_.starts_with("\xEF\xBB\xBF")) text_.remove_prefix(3);
}

void CsvRecords::refuse(std::size_t line, std::string_view what) const {
  throw CsvFault(name_ + ":" + std::to_string(line) + ": " + std::string(what));
}

std::vector<std::string> CsvRecords::header() {
  if (text_.empty()) refuse(1, "file is empty; it needs a header that names the columns");
  // A field goes to a terminal as it is where a command prints a table, so it must not be able to act on one.
  if (const auto at = first_unprintable(text_); at != std::string_view::npos)
    refuse(1 + static_cast<std::size_t>(std::ranges::count(text_.substr(0, at), '\n')),
           "character " + printable(text_.substr(at, 1)) +
               ", which is not text; the file is damaged or not CSV: restore it");
  next();
  std::vector<std::string> header(fields_.begin(), fields_.end());
  std::unordered_set<std::string_view> seen;
  for (const auto& name : header) {
    if (name.empty()) refuse(1, "a column has no name; name every column");
    if (!seen.insert(name).second) refuse(1, "column '" + echo(name) + "' occurs twice; keep one");
  }
  columns_ = header.size();
  return header;
}

void CsvRecords::next_row() {
  next();
  if (fields_.size() != columns_)
    refuse(record_line_, "row has " + count_of_fields(fields_.size()) + ", the header has " + std::to_string(columns_) +
                             "; add or remove fields, or restore the file");
}

void CsvRecords::next() {
  record_line_ = line_;
  fields_.clear();
  unquoted_.clear();
  if (take_line_end()) refuse(record_line_, "blank line; remove it");
  for (;;) {
    fields_.push_back(peek() == '"' ? quoted() : plain());
    if (done() || take_line_end()) break;
    if (peek() != ',') refuse(line_, "text after a closing quote; put the whole field in quotes, inner quotes doubled");
    ++position_;
  }
  for (auto& [field, text] : unquoted_) fields_[field] = text;
}

bool CsvRecords::take_line_end() {
  const std::size_t length = rest().starts_with("\r\n") ? 2 : (rest().starts_with('\n') ? 1 : 0);
  position_ += length;
  line_ += length > 0 ? 1 : 0;
  return length > 0;
}

std::string_view CsvRecords::plain() {
  const auto end = std::min(text_.find_first_of(",\r\n\"", position_), text_.size());
  const auto field = text_.substr(position_, end - position_);
  position_ = end;
  if (peek() == '"') refuse(line_, "quote inside a field; put the whole field in quotes, inner quotes doubled");
  if (peek() == '\r' && !rest().starts_with("\r\n"))
    refuse(line_, "carriage return without a line feed; end lines with \\n or \\r\\n");
  return field;
}

std::string_view CsvRecords::quoted() {
  const auto first_line = line_;
  const auto begin = ++position_;
  std::string text;
  for (bool plain = true;; plain = false) {
    const auto quote = text_.find('"', position_);
    if (quote == std::string_view::npos) refuse(first_line, "quote is never closed; close it or restore the file");
    const auto part = text_.substr(position_, quote - position_);
    line_ += static_cast<std::size_t>(std::ranges::count(part, '\n'));
    position_ = quote + 1;
    if (peek() != '"' && plain) return text_.substr(begin, quote - begin);
    text += part;
    if (peek() != '"') break;
    text += '"';
    ++position_;
  }
  unquoted_.emplace_back(fields_.size(), std::move(text));
  return {};
}

}  // namespace bezierbench
