// SPDX-License-Identifier: MIT
#include "experiments/bundle/csv.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>
#include <unordered_set>
#include <utility>

#include "experiments/failure.hpp"
#include "reference/number/csv_records.hpp"

namespace bezierbench::bundle {
namespace {

using Fields = std::vector<std::string>;

// The first repeated name, or nullptr.
const std::string* repeated(const Fields& names) {
  std::unordered_set<std::string_view> seen;
  for (const std::string& name : names)
    if (!seen.insert(name).second) return &name;
  return nullptr;
}

bool has_nul(const Fields& fields) {
  return std::ranges::any_of(fields, [](const std::string& field) { return field.find('\0') != std::string::npos; });
}

}  // namespace

std::string csv_line(const Fields& fields) {
  std::string line;
  for (std::size_t i = 0; i < fields.size(); ++i) {
    if (i > 0) line += ',';
    // A lone empty field would be a blank line, which readers skip or refuse.
    line += fields.size() == 1 && fields[i].empty() ? "\"\"" : csv_field(fields[i]);
  }
  return line + '\n';
}

CsvTable::CsvTable(std::vector<std::string> columns) : columns_(std::move(columns)) {
  const bool nameless = columns_.empty() || std::ranges::find(columns_, "") != columns_.end();
  if (nameless || repeated(columns_) || has_nul(columns_))
    throw std::invalid_argument("a CSV table needs distinct column names");
}

void CsvTable::add_row(std::vector<std::string> fields) {
  if (fields.size() != columns_.size() || has_nul(fields))
    throw std::invalid_argument(
        fmt::format("a row of {} for {} columns, or a NUL byte", count_of_fields(fields.size()), columns_.size()));
  rows_.push_back(std::move(fields));
}

std::string CsvTable::text() const {
  std::string text = csv_line(columns_);
  for (const Fields& row : rows_) text += csv_line(row);
  return text;
}

bool CsvDocument::has_column(std::string_view name) const { return std::ranges::find(header_, name) != header_.end(); }

std::size_t CsvDocument::column(std::string_view name) const {
  const auto found = std::ranges::find(header_, name);
  if (found == header_.end())
    throw Failure(Exit::input_output, "{}:1: no column '{}'; check that this is the right file", file_name_, name);
  return static_cast<std::size_t>(found - header_.begin());
}

const std::string& CsvDocument::at(std::size_t row, std::string_view column_name) const {
  return rows_.at(row)[column(column_name)];
}

CsvDocument parse_csv(std::string_view text, std::string_view file_name) {
  try {
    CsvRecords records(text, std::string(file_name));
    CsvDocument document;
    document.file_name_ = file_name;
    document.header_ = records.header();
    while (!records.done()) {
      records.next_row();
      document.rows_.emplace_back(records.fields().begin(), records.fields().end());
      document.lines_.push_back(records.line());
    }
    return document;
  } catch (const CsvFault& fault) {
    throw Failure(Exit::input_output, fault.what());
  }
}

}  // namespace bezierbench::bundle
