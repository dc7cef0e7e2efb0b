// SPDX-License-Identifier: MIT
#include "experiments/compare/join.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <deque>
#include <iterator>
#include <map>
#include <utility>

#include "experiments/bundle/bundle.hpp"
#include "experiments/bundle/schema/columns.hpp"
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

namespace {

constexpr std::string_view unknown = "unknown";

}  // namespace

std::string Side::fact(std::string_view fact_name) const {
  const auto found = std::ranges::find(facts, fact_name, &bundle::Fact::name);
  return found == facts.end() ? std::string(unknown) : found->value;
}

const bundle::CsvDocument& Side::table(const std::string& file) const {
  static const bundle::CsvDocument none;
  const auto found = tables.find(file);
  return found == tables.end() ? none : found->second;
}

Side read_side(const std::filesystem::path& path) {
  const auto bundle = bundle::BundleDirectory::open(path);
  Side side{.name = path.string(), .manifest = bundle.manifest()};
  for (const auto file : {std::string_view("machine.json"), bundle::manifest_name})
    std::ranges::move(bundle::facts(bundle.read_listed(file), bundle.place(file)), std::back_inserter(side.facts));
  for (const auto& declared : bundle::declared_tables())
    if (declared.is_deterministic || declared.file == timing_file || declared.file == cost_file)
      if (auto table = bundle.table(declared.file)) side.tables.emplace(declared.file, std::move(*table));
  return side;
}

std::vector<FactDifference> fact_differences(const Side& a, const Side& b) {
  std::vector<FactDifference> differences;
  for (const auto& [name, value] : a.facts)
    if (const auto other = b.fact(name); other != value) differences.push_back({name, value, other});
  for (const auto& [name, value] : b.facts)
    if (std::ranges::find(a.facts, name, &bundle::Fact::name) == a.facts.end() && value != unknown)
      differences.push_back({name, std::string(unknown), value});
  return differences;
}

bool same_machine(const Side& a, const Side& b) {
  constexpr std::array<std::string_view, 3> groups{"cpu.", "caches.", "memory."};
  if (a.fact("cpu.model_name") == unknown) return false;
  return std::ranges::none_of(fact_differences(a, b), [&](const auto& difference) {
    return std::ranges::any_of(groups, [&](const auto group) { return difference.name.starts_with(group); });
  });
}

}  // namespace bezierbench::compare
