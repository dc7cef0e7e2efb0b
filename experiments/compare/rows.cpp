// SPDX-License-Identifier: MIT
#include "experiments/compare/rows.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cstdint>
#include <deque>
#include <map>
#include <stdexcept>

#include "experiments/number/number.hpp"

namespace bezierbench::compare {
namespace {

/// The name of the method's column in Inputs, whatever the table calls it.
constexpr std::string_view method_name = "method";

/// The name of a key column in Inputs.
std::string_view input_name(const bundle::DeclaredTable& declared, const bundle::Column& column) {
  return column.name == declared.method ? method_name : std::string_view(column.name);
}

std::string canonical(const std::string& text) {
  const auto value = number::parse_number(text);
  if (!value) return text;
  const auto whole = number::whole(*value);
  return whole ? std::to_string(*whole) : number::decimal(*value);
}

/// Whether some table has a key column of this name.
bool is_input(std::string_view name) {
  return std::ranges::any_of(bundle::declared_tables(), [&](const bundle::DeclaredTable& table) {
    return std::ranges::any_of(table.columns, [&](const bundle::Column& column) {
      return column.is_key && input_name(table, column) == name;
    });
  });
}

}  // namespace

Inputs::Inputs(const bundle::DeclaredTable& declared, const bundle::CsvDocument& table, std::size_t row,
               const bundle::CsvDocument& other) {
  for (const auto& column : declared.columns) {
    if (!column.is_key) continue;
    const bool there = table.has_column(column.name) && other.has_column(column.name);
    const std::string text = there ? table.at(row, column.name) : "";
    fields_.emplace_back(input_name(declared, column), column.is_number ? canonical(text) : text);
  }
}

const std::string& Inputs::field(std::string_view name) const {
  static const std::string none;
  const auto found = std::ranges::find(fields_, name, &Field::first);
  if (found != fields_.end()) return found->second;
  if (!is_input(name)) throw std::invalid_argument(fmt::format("{}: no key of any table", name));
  return none;
}

Inputs Inputs::without_method() const {
  Inputs rest = *this;
  std::erase_if(rest.fields_, [](const Field& field) { return field.first == method_name; });
  return rest;
}

std::string Inputs::words() const {
  std::string text;
  for (const auto& [name, field] : fields_)
    if (!field.empty()) text += fmt::format("{}{} {}", text.empty() ? "" : ", ", name, field);
  return text;
}

RowMatch match_rows(const bundle::DeclaredTable& declared, const bundle::CsvDocument& a, const bundle::CsvDocument& b) {
  const auto& other_of_a = b.header().empty() ? a : b;  // a table that is on one side only has all of its keys
  const auto& other_of_b = a.header().empty() ? b : a;
  std::map<Inputs, std::deque<std::size_t>> rows_of_b;
  for (std::size_t row = 0; row < b.row_count(); ++row) rows_of_b[Inputs(declared, b, row, other_of_b)].push_back(row);
  RowMatch match;
  for (std::size_t row = 0; row < a.row_count(); ++row) {
    Inputs inputs(declared, a, row, other_of_a);
    const auto found = rows_of_b.find(inputs);
    if (found == rows_of_b.end() || found->second.empty()) {
      match.only_a.push_back(std::move(inputs));
    } else {
      match.pairs.push_back({std::move(inputs), row, found->second.front()});
      found->second.pop_front();
    }
  }
  for (const auto& [inputs, rows] : rows_of_b) match.only_b.insert(match.only_b.end(), rows.size(), inputs);
  return match;
}

bool same_value(std::string_view a, std::string_view b) {
  const auto x = number::parse_number(a);
  const auto y = number::parse_number(b);
  if (!x || !y) return a == b;
  return std::bit_cast<std::uint64_t>(*x) == std::bit_cast<std::uint64_t>(*y);
}

}  // namespace bezierbench::compare
