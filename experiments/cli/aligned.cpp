// SPDX-License-Identifier: MIT
#include "experiments/cli/aligned.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

namespace bezierbench::cli {

std::string aligned(const bundle::CsvDocument& table) {
  std::vector<std::vector<std::string>> lines{table.header()};
  for (std::size_t row = 0; row < table.row_count(); ++row) lines.push_back(table.row(row));
  std::vector<std::size_t> widths(table.header().size(), 0);
  for (const auto& line : lines)
    for (std::size_t k = 0; k < line.size(); ++k) widths[k] = std::max(widths[k], line[k].size());
  std::string text;
  for (const auto& line : lines) {
    std::string out;
    for (std::size_t k = 0; k < line.size(); ++k) out += fmt::format("{:<{}}  ", line[k], widths[k]);
    out.erase(out.find_last_not_of(' ') + 1);
    text += out + "\n";
  }
  return text;
}

}  // namespace bezierbench::cli
