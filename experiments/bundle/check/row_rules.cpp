// SPDX-License-Identifier: MIT
#include "experiments/bundle/check/row_rules.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <string_view>

#include "experiments/bundle/check/few_lines.hpp"
#include "experiments/bundle/csv.hpp"
#include "experiments/bundle/schema/columns.hpp"
#include "reference/number/number.hpp"

namespace bezierbench::bundle {
namespace {

/// The text that `*` stands for where the pattern matches the name. A pattern without `*` matches itself, with "".
std::optional<std::string> starred(std::string_view pattern, std::string_view name) {
  const auto star = pattern.find('*');
  if (star == std::string_view::npos) return pattern == name ? std::optional(std::string()) : std::nullopt;
  const auto before = pattern.substr(0, star);
  const auto after = pattern.substr(star + 1);
  if (name.size() <= before.size() + after.size() || !name.starts_with(before) || !name.ends_with(after))
    return std::nullopt;
  return std::string(name.substr(star, name.size() - before.size() - after.size()));
}

std::string with_star(std::string_view pattern, std::string_view text) {
  const auto star = pattern.find('*');
  if (star == std::string_view::npos) return std::string(pattern);
  return fmt::format("{}{}{}", pattern.substr(0, star), text, pattern.substr(star + 1));
}

/// The lists of columns of the table whose numbers ascend.
std::vector<std::vector<std::string>> ascending_columns_of(const CsvDocument& table) {
  std::vector<std::vector<std::string>> all;
  for (const auto& patterns : ascending_columns())
    for (const auto& name : table.header())
      if (const auto text = starred(patterns.front(), name)) {
        auto& columns = all.emplace_back();
        for (const auto& pattern : patterns)
          if (auto column = with_star(pattern, *text); table.has_column(column)) columns.push_back(std::move(column));
      }
  return all;
}

void check_order(const CsvDocument& table, const std::vector<std::string>& columns, FewLines& lines) {
  for (std::size_t row = 0; row < table.row_count(); ++row) {
    const std::string* before = nullptr;
    double least = 0;
    for (const auto& column : columns) {
      const auto number = number::parse_number(table.at(row, column));
      if (!number) continue;
      if (before != nullptr && *number < least)
        lines.add(fmt::format("{}:{}: {} is above {}", table.file_name(), table.line(row), *before, column));
      before = &column;
      least = *number;
    }
  }
}

/// Numbers above their limits; both are known to a relative 2^-20 only.
void check_limit(const CsvDocument& table, const Column& column, FewLines& lines) {
  const Limit& limit = *column.at_most;
  if (!table.has_column(limit.column) || (!limit.unless.empty() && !table.has_column(limit.unless))) return;
  for (std::size_t row = 0; row < table.row_count(); ++row) {
    if (!limit.unless.empty() && table.at(row, limit.unless) != "0") continue;
    const auto number = number::parse_number(table.at(row, column.name));
    const auto most = number::parse_number(table.at(row, limit.column));
    if (number && most && *number > *most * (1 + 0x1p-20))
      lines.add(fmt::format("{}:{}: {} is above {}", table.file_name(), table.line(row), column.name, limit.column));
  }
}

bool is_innocent(const std::string& field) { return field.empty() || field == "0" || field == "yes"; }

}  // namespace

std::set<std::string, std::less<>> promising_methods(const CsvDocument& methods_csv) {
  std::set<std::string, std::less<>> ids;
  for (std::size_t row = 0; row < methods_csv.row_count(); ++row)
    if (!methods_csv.at(row, "bound").empty()) ids.insert(methods_csv.at(row, "id"));
  return ids;
}

std::vector<std::string> row_faults(const std::string& file, const CsvDocument& table,
                                    const std::set<std::string, std::less<>>& promising) {
  const auto& declared = *declared_table(file);
  std::vector<std::string> faults;
  FewLines lines(table.file_name());
  for (const auto& column : declared.columns) {
    if (column.at_most && table.has_column(column.name)) check_limit(table, column, lines);
    if (column.accuses.empty() || !table.has_column(column.name)) continue;
    for (std::size_t row = 0; row < table.row_count(); ++row) {
      const auto& field = table.at(row, column.name);
      if (is_innocent(field) || (column.is_of_promise && !promising.contains(table.at(row, declared.method)))) continue;
      const auto count = field == "no" ? std::string() : field + " ";
      lines.add(fmt::format("{}:{}: {}{}", table.file_name(), table.line(row), count, column.accuses));
    }
    std::ranges::move(lines.take(), std::back_inserter(faults));
  }
  for (const auto& columns : ascending_columns_of(table)) check_order(table, columns, lines);
  std::ranges::move(lines.take(), std::back_inserter(faults));
  return faults;
}

}  // namespace bezierbench::bundle
