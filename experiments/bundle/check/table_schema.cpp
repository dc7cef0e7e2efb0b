// SPDX-License-Identifier: MIT
#include "experiments/bundle/check/table_schema.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <optional>
#include <set>

#include "experiments/bundle/check/few_lines.hpp"
#include "experiments/bundle/check/schema.hpp"
#include "experiments/bundle/schema/columns.hpp"
#include "experiments/number/number.hpp"

namespace bezierbench::bundle {
namespace {

using Json = Schema::Json;

/// The schema of a row of the table.
const Json& row_schema(std::string_view name) {
  return tables_schema().resolved(tables_schema().document().at("properties").at(std::string(name))).at("items");
}

/// The JSON values that a field may stand for: null, a number that the program writes in this way, text.
std::vector<Json> readings(const std::string& text) {
  std::vector<Json> all;
  if (text.empty()) all.emplace_back(nullptr);
  constexpr std::size_t longest_number = 32;
  if (text.size() <= longest_number) {
    static const std::string integer = "^-?(0|[1-9][0-9]*)$";
    if (const auto whole = number::parse_integer(text); whole && matches(integer, text)) all.emplace_back(*whole);
    static const std::string decimal = "^-?[0-9]+(\\.[0-9]+)?(e[+-][0-9]+)?$";
    if (const auto number = number::parse_number(text); number && matches(decimal, text))
      if (number::decimal(*number) == text) all.emplace_back(*number);
  }
  all.emplace_back(text);
  return all;
}

/// Why the column admits no reading of a field: the reason for its reading as text. Empty where it admits one.
std::optional<std::string> field_fault(const Json& column, const std::string& text) {
  std::optional<std::string> why;
  for (const Json& value : readings(text)) {
    why = tables_schema().fault(column, value);
    if (!why) return why;
  }
  return why;
}

std::string at(const CsvDocument& table, std::size_t line, const std::string& what) {
  return fmt::format("{}:{}: {}", table.file_name(), line, what);
}

void check_header(const Json& rows, const std::vector<std::string>& digested, const CsvDocument& table,
                  FewLines& lines) {
  for (const auto& name : table.header())
    if (!rows.at("properties").contains(name))
      lines.add(at(table, 1, fmt::format("column '{}' does not belong there", name)));
  auto wanted = rows.at("required").get<std::vector<std::string>>();
  for (const auto& name : digested)
    if (std::ranges::find(wanted, name) == wanted.end()) wanted.push_back(name);
  for (const auto& name : wanted)
    if (!table.has_column(name)) lines.add(at(table, 1, fmt::format("column '{}' is missing", name)));
}

void check_column(const Json& column, std::size_t place, const CsvDocument& table, FewLines& lines) {
  // Texts that were found valid. Most columns repeat a few texts; long ones rarely repeat and are not worth the memory.
  std::set<std::string> good;
  constexpr std::size_t most_texts = 1000;
  constexpr std::size_t longest = 64;
  for (std::size_t row = 0; row < table.row_count(); ++row) {
    const std::string& text = table.row(row)[place];
    if (good.contains(text)) continue;
    if (const auto why = field_fault(column, text))
      lines.add(at(table, table.line(row), table.header()[place] + *why));
    else if (good.size() < most_texts && text.size() <= longest)
      good.insert(text);
  }
}

}  // namespace

bool is_table_name(std::string_view name) { return declared_table(name) != nullptr; }

std::vector<std::string> table_faults(std::string_view name, const CsvDocument& table) {
  const Json& rows = row_schema(name);
  const Json& columns = rows.at("properties");
  FewLines of_header(table.file_name());
  check_header(rows, declared_table(name)->digested(), table, of_header);
  FewLines of_fields(table.file_name());
  for (std::size_t place = 0; place < table.header().size(); ++place)
    if (const auto column = columns.find(table.header()[place]); column != columns.end())
      check_column(*column, place, table, of_fields);
  auto faults = of_header.take();
  std::ranges::move(of_fields.take(), std::back_inserter(faults));
  return faults;
}

}  // namespace bezierbench::bundle
