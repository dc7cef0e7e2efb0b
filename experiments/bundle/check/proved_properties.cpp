// SPDX-License-Identifier: MIT
#include "experiments/bundle/check/proved_properties.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <sstream>

#include "experiments/bundle/check/few_lines.hpp"
#include "reference/number/number.hpp"

namespace bezierbench::bundle {
namespace {

bool has_columns(const CsvDocument& table, const auto& names) {
  return std::ranges::all_of(names, [&](std::string_view name) { return table.has_column(name); });
}

}  // namespace

void ProvedProperties::read(std::string_view file, const CsvDocument& table) {
  if (file == "methods.csv" && has_columns(table, std::array{"id", "form", "guarantees"})) {
    for (std::size_t row = 0; row < table.row_count(); ++row)
      if (table.at(row, "form") == "bernstein") proved_[table.at(row, "id")] = table.at(row, "guarantees");
  } else if (file.starts_with("guarantees") &&
             has_columns(table, std::array{"method", "property", "degree", "verdict", "broken"})) {
    for (std::size_t row = 0; row < table.row_count(); ++row)
      tried_.push_back({table.at(row, "method"), table.at(row, "property"), table.at(row, "degree"),
                        table.at(row, "verdict"), table.at(row, "broken"), table.file_name(), table.line(row)});
  }
}

bool ProvedProperties::is_proved(const Tried& row) const {
  const auto listed = proved_.find(row.method);
  if (listed == proved_.end()) return false;
  std::istringstream words(listed->second);
  for (std::string word; words >> word;) {
    const auto colon = word.find(':');
    if (word.substr(0, colon) != row.property) continue;
    if (colon == std::string::npos) return true;
    const auto degree = number::parse_integer(row.degree);
    const auto most = number::parse_integer(word.substr(colon + 1));
    if (degree && most && *degree <= *most) return true;
  }
  return false;
}

std::string ProvedProperties::fault(const Tried& row) const {
  if (row.verdict != "refuted" && row.broken != "0")
    return fmt::format("{} inputs break {} of {}, which is not refuted", row.broken, row.property, row.method);
  if (!proved_.contains(row.method)) return "";
  const auto stated = [&](std::string_view here, std::string_view there) {
    return fmt::format("{} of {} is {}, and {} according to methods.csv", row.property, row.method, here, there);
  };
  if (row.verdict == "refuted") return is_proved(row) ? stated("refuted", "proved") : "";
  if ((row.verdict == "proved") == is_proved(row)) return "";
  return row.verdict == "proved" ? stated("proved", "not proved") : stated("not refuted", "proved");
}

std::vector<std::string> ProvedProperties::faults() const {
  if (tried_.empty()) return {};
  FewLines lines(tried_.front().file);
  for (const auto& row : tried_)
    if (const auto what = fault(row); !what.empty()) lines.add(fmt::format("{}:{}: {}", row.file, row.line, what));
  return lines.take();
}

}  // namespace bezierbench::bundle
