// SPDX-License-Identifier: MIT
#include "experiments/bundle/check/table_schema.hpp"

#include <fmt/format.h>
#include <regex.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>
#include <optional>
#include <set>
#include <stdexcept>

#include "experiments/bundle/check/few_lines.hpp"
#include "experiments/bundle/schema/columns.hpp"
#include "experiments/bundle/schema/tables_schema.hpp"
#include "reference/number/echo.hpp"
#include "reference/number/number.hpp"

namespace bezierbench::bundle {
namespace {

using Json = nlohmann::ordered_json;

/// Whether some part of `text` matches the pattern. std::regex would overflow the stack on the long fields of worst.csv.
bool matches(const std::string& pattern, const std::string& text) {
  static std::map<std::string, regex_t> compiled;  // for the life of the program: the schema has a handful of patterns
  const auto [place, is_new] = compiled.try_emplace(pattern);
  if (is_new && regcomp(&place->second, pattern.c_str(), REG_EXTENDED | REG_NOSUB) != 0)
    throw std::logic_error("tables.schema.json: not a regular expression: " + pattern);
  return text.find('\0') == std::string::npos && regexec(&place->second, text.c_str(), 0, nullptr, 0) == 0;
}

bool is_whole(const std::string& text) {
  const auto whole = number::parse_integer(text);
  return whole && std::to_string(*whole) == text;
}

/// The number that the program writes as `text`; empty for a text with superfluous digits, which it never writes.
std::optional<double> number_of(const std::string& text) {
  const auto number = number::parse_number(text);
  const bool is_written_so = number && std::isfinite(*number) && (number::decimal(*number) == text || is_whole(text));
  return is_written_so ? number : std::nullopt;
}

bool has_type(const std::string& text, const Json& type) {
  if (type == "null") return text.empty();
  if (type == "integer") {
    const auto number = number_of(text);  // 100000 may be written as 1e+05
    return number && std::trunc(*number) == *number;
  }
  if (type == "number") return number_of(text).has_value();
  return type == "string";
}

/// Whether `text` fulfils a keyword of JSON Schema that constrains values; any other keyword describes the column.
bool fulfils(const std::string& text, const std::string& keyword, const Json& value) {
  const auto is_text = [&](const Json& one) { return one.is_null() ? text.empty() : one == text; };
  const auto is_number = [&](const auto& holds) {
    const auto number = number_of(text);
    return !number || holds(*number, value.get<double>());
  };
  if (keyword == "type")
    return value.is_array() ? std::ranges::any_of(value, [&](const Json& one) { return has_type(text, one); })
                            : has_type(text, value);
  if (keyword == "enum") return std::ranges::any_of(value, is_text);
  if (keyword == "const") return is_text(value);
  if (keyword == "minimum") return is_number(std::greater_equal<>());
  if (keyword == "exclusiveMinimum") return is_number(std::greater<>());
  if (keyword == "maximum") return is_number(std::less_equal<>());
  if (keyword == "minLength") return text.size() >= value.get<std::size_t>();
  if (keyword == "pattern") return matches(value.get<std::string>(), text);
  return true;
}

/// The part of a column's schema that does not admit the field, such as `type "integer"`. Empty where all do.
std::optional<std::string> broken_part(const Json& schema, const std::string& text) {
  for (const auto& [keyword, value] : schema.items()) {
    std::optional<std::string> broken;
    if (keyword == "$ref") {
      broken = broken_part(referred(schema), text);
    } else if (keyword == "anyOf") {
      if (std::ranges::none_of(value, [&](const Json& one) { return !broken_part(one, text); }))
        broken = broken_part(value.front(), text);
    } else if (!fulfils(text, keyword, value)) {
      broken = fmt::format("{} {}", keyword, value.dump());
    }
    if (broken) return broken;
  }
  return std::nullopt;
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
  std::set<std::string> valid;  // most columns repeat a few texts
  constexpr std::size_t most_texts = 1000;
  for (std::size_t row = 0; row < table.row_count(); ++row) {
    const std::string& text = table.row(row)[place];
    if (valid.contains(text)) continue;
    if (const auto broken = broken_part(column, text))
      lines.add(at(table, table.line(row),
                   fmt::format("{} is \"{}\"; its schema requires {}", table.header()[place], echo(text), *broken)));
    else if (valid.size() < most_texts)
      valid.insert(text);
  }
}

}  // namespace

bool is_table_name(std::string_view name) { return declared_table(name) != nullptr; }

std::vector<std::string> table_faults(std::string_view name, const CsvDocument& table) {
  const Json* declared = &tables_schema().at("properties").at(std::string(name));
  while (declared->contains("$ref")) declared = &referred(*declared);
  const Json& rows = declared->at("items");
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
