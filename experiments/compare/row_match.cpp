// SPDX-License-Identifier: MIT
#include "experiments/compare/row_match.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <map>
#include <stdexcept>

#include "experiments/number/number.hpp"

namespace bezierbench::compare {
namespace {

struct InputColumn {
  std::string_view name;
  bool is_number;  ///< a study may be called 2.20, which is not 2.2
};

constexpr std::array columns{
    InputColumn{"study", false},     InputColumn{"table", false},  InputColumn{"curve", false},
    InputColumn{"method", false},    InputColumn{"scalar", false}, InputColumn{"dimension", true},
    InputColumn{"degree", true},     InputColumn{"mode", false},   InputColumn{"coordinate_range", true},
    InputColumn{"t_min", true},      InputColumn{"t_max", true},   InputColumn{"generator", false},
    InputColumn{"trials", true},     InputColumn{"budget", true},  InputColumn{"baseline", false},
    InputColumn{"statistic", false}, InputColumn{"order", true},   InputColumn{"tolerance", true},
    InputColumn{"placement", false}, InputColumn{"data", false},   InputColumn{"points", true},
    InputColumn{"spacing", false},   InputColumn{"segment", true}, InputColumn{"index", true},
};

/// A conversion is the method of its table.
constexpr std::string_view conversion = "conversion";

/// Numbers of rows, which other rows can shift, and remarks for readers.
constexpr std::array<std::string_view, 3> labels{"worst_id", "search_id", "note"};

std::string_view column_in(const bundle::CsvDocument& table, std::string_view input) {
  return input == "method" && table.has_column(conversion) ? conversion : input;
}

std::string canonical(const std::string& text) {
  const auto value = number::parse_number(text);
  if (!value) return text;
  const auto whole = number::whole(*value);
  return whole ? std::to_string(*whole) : number::decimal(*value);
}

std::size_t place(std::string_view column) {
  for (std::size_t k = 0; k < columns.size(); ++k)
    if (columns[k].name == column) return k;
  throw std::invalid_argument(fmt::format("{}: no input column", column));
}

bool is_input(std::string_view column) {
  return column == conversion || std::ranges::find(columns, column, &InputColumn::name) != columns.end();
}

}  // namespace

Inputs::Inputs(const bundle::CsvDocument& table, std::size_t row, const bundle::CsvDocument& other) {
  for (const auto& [name, is_number] : columns) {
    const auto column = column_in(table, name);
    const bool there = table.has_column(column) && other.has_column(column_in(other, name));
    const std::string text = there ? table.at(row, column) : "";
    fields_.push_back(is_number ? canonical(text) : text);
  }
}

const std::string& Inputs::field(std::string_view column) const { return fields_.at(place(column)); }

Inputs Inputs::without_method() const {
  Inputs rest = *this;
  rest.fields_.at(place("method")).clear();
  return rest;
}

std::string Inputs::words() const {
  std::string text;
  for (std::size_t k = 0; k < fields_.size(); ++k)
    if (!fields_[k].empty()) text += fmt::format("{}{} {}", text.empty() ? "" : ", ", columns[k].name, fields_[k]);
  return text;
}

RowMatch match_rows(const bundle::CsvDocument& a, const bundle::CsvDocument& b) {
  std::map<Inputs, std::vector<std::size_t>> rows_of_b;
  for (std::size_t row = b.row_count(); row-- > 0;) rows_of_b[Inputs(b, row, a)].push_back(row);  // the first is last
  RowMatch match;
  for (std::size_t row = 0; row < a.row_count(); ++row) {
    Inputs inputs(a, row, b);
    const auto found = rows_of_b.find(inputs);
    if (found == rows_of_b.end() || found->second.empty()) {
      ++match.only_a;
      continue;
    }
    match.pairs.push_back({std::move(inputs), row, found->second.back()});
    found->second.pop_back();
  }
  match.only_b = b.row_count() - match.pairs.size();
  return match;
}

std::vector<std::string> result_columns(const bundle::CsvDocument& a, const bundle::CsvDocument& b) {
  std::vector<std::string> results;
  for (const auto& column : a.header())
    if (b.has_column(column) && !is_input(column) && std::ranges::find(labels, column) == labels.end())
      results.push_back(column);
  return results;
}

bool same_value(std::string_view a, std::string_view b) {
  const auto x = number::parse_number(a);
  const auto y = number::parse_number(b);
  if (!x || !y) return a == b;
  return std::bit_cast<std::uint64_t>(*x) == std::bit_cast<std::uint64_t>(*y);
}

}  // namespace bezierbench::compare
