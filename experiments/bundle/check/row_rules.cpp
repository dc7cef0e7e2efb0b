// SPDX-License-Identifier: MIT
#include "experiments/bundle/check/row_rules.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <string_view>

#include "experiments/bundle/check/few_lines.hpp"
#include "experiments/bundle/csv.hpp"
#include "experiments/bundle/schema/columns.hpp"

namespace bezierbench::bundle {
namespace {

bool is_innocent(const std::string& field) { return field.empty() || field == "0" || field == "yes"; }

}  // namespace

MethodFacts method_facts(const CsvDocument& methods_csv) {
  MethodFacts facts;
  for (std::size_t row = 0; row < methods_csv.row_count(); ++row) {
    if (!methods_csv.at(row, "bound").empty()) facts.promising.insert(methods_csv.at(row, "id"));
    if (methods_csv.at(row, "citation") == external_citation) facts.external.insert(methods_csv.at(row, "id"));
  }
  return facts;
}

std::vector<std::string> row_faults(const std::string& file, const CsvDocument& table, const MethodFacts& methods) {
  const auto& declared = *declared_table(file);
  std::vector<std::string> faults;
  FewLines lines(table.file_name());
  for (const auto& column : declared.columns) {
    if (column.accuses.empty() || !table.has_column(column.name)) continue;
    for (std::size_t row = 0; row < table.row_count(); ++row) {
      const auto& field = table.at(row, column.name);
      if (is_innocent(field)) continue;
      if (column.is_of_promise) {
        const auto& method = table.at(row, declared.method);
        if (!methods.promising.contains(method) && !(column.is_of_external && methods.external.contains(method)))
          continue;
      }
      const auto count = field == "no" ? std::string() : field + " ";
      lines.add(fmt::format("{}:{}: {}{}", table.file_name(), table.line(row), count, column.accuses));
    }
    std::ranges::move(lines.take(), std::back_inserter(faults));
  }
  return faults;
}

}  // namespace bezierbench::bundle
