// SPDX-License-Identifier: MIT
#include "experiments/compare/join.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cstdint>
#include <deque>
#include <map>

#include "reference/number/number.hpp"

namespace bezierbench::compare {
namespace {

constexpr const char* method_name = "method";

std::string canonical(const std::string& text) {
  const auto value = number::parse_number(text);
  if (!value) return text;
  const auto whole = number::whole(*value);
  return whole ? std::to_string(*whole) : number::decimal(*value);
}

}  // namespace

Inputs::Inputs(const bundle::DeclaredTable& declared, const bundle::CsvDocument& table, std::size_t row,
               const bundle::CsvDocument& other) {
  for (const auto& column : declared.columns) {
    if (!column.is_key) continue;
    const bool there = table.has_column(column.name) && other.has_column(column.name);
    const std::string text = there ? table.at(row, column.name) : "";
    fields_.emplace_back(column.name == declared.method ? method_name : column.name,
                         column.is_number ? canonical(text) : text);
  }
}

const std::string& Inputs::field(std::string_view name) const {
  static const std::string none;
  const auto found = std::ranges::find(fields_, name, &Field::first);
  return found == fields_.end() ? none : found->second;
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

Join join(const bundle::DeclaredTable& declared, const bundle::CsvDocument& a, const bundle::CsvDocument& b) {
  const auto& other_of_a = b.header().empty() ? a : b;  // a table that is on one side only has all of its keys
  const auto& other_of_b = a.header().empty() ? b : a;
  std::map<Inputs, std::deque<std::size_t>> rows_of_b;
  for (std::size_t row = 0; row < b.row_count(); ++row) rows_of_b[Inputs(declared, b, row, other_of_b)].push_back(row);
  Join joined;
  for (std::size_t row = 0; row < a.row_count(); ++row) {
    Inputs inputs(declared, a, row, other_of_a);
    const auto found = rows_of_b.find(inputs);
    if (found == rows_of_b.end() || found->second.empty()) {
      joined.only_a.push_back(std::move(inputs));
    } else {
      joined.pairs.push_back({std::move(inputs), row, found->second.front()});
      found->second.pop_front();
    }
  }
  for (const auto& [inputs, rows] : rows_of_b) joined.only_b.insert(joined.only_b.end(), rows.size(), inputs);
  return joined;
}

bool same_value(std::string_view a, std::string_view b) {
  const auto x = number::parse_number(a);
  const auto y = number::parse_number(b);
  if (!x || !y) return a == b;
  return std::bit_cast<std::uint64_t>(*x) == std::bit_cast<std::uint64_t>(*y);
}

}  // namespace bezierbench::compare
