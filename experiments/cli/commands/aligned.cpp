// SPDX-License-Identifier: MIT
#include "experiments/cli/commands/aligned.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "experiments/bundle/csv.hpp"
#include "experiments/echo.hpp"

namespace bezierbench::cli {

std::string aligned(std::vector<std::vector<std::string>> lines) {
  for (auto& line : lines)
    for (auto& field : line) field = printable(field);
  std::vector<std::size_t> widths;
  for (const auto& line : lines) {
    if (line.size() == 1) continue;
    widths.resize(std::max(widths.size(), line.size()), 0);
    for (std::size_t k = 0; k < line.size(); ++k) widths[k] = std::max(widths[k], line[k].size());
  }
  std::string text;
  for (const auto& line : lines) {
    if (line.size() == 1) {
      text += line.front() + "\n";
      continue;
    }
    std::string out;
    for (std::size_t k = 0; k < line.size(); ++k) out += fmt::format("{:<{}}  ", line[k], widths[k]);
    out.erase(out.find_last_not_of(' ') + 1);
    text += out + "\n";
  }
  return text;
}

std::string aligned_csv(std::string_view csv) {
  const auto document = bundle::parse_csv(csv, "table");
  std::vector<std::vector<std::string>> lines{document.header()};
  for (std::size_t row = 0; row < document.row_count(); ++row) lines.push_back(document.row(row));
  return aligned(std::move(lines));
}

}  // namespace bezierbench::cli
