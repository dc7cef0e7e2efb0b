// SPDX-License-Identifier: MIT
#include "experiments/cli/curve/coordinate_columns.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "experiments/echo.hpp"
#include "experiments/failure.hpp"
#include "experiments/number/number.hpp"

namespace bezierbench::cli {
namespace {

constexpr std::array<std::string_view, 3> axes{"x", "y", "z"};

/// Whether a line has numbers only, separated in any way that data are found in.
bool has_numbers_only(std::string_view line) {
  constexpr std::string_view separators = ",; \t\r()[]{}";
  auto begin = line.find_first_not_of(separators);
  const bool any = begin != std::string_view::npos;
  while (begin != std::string_view::npos) {
    const auto end = std::min(line.find_first_of(separators, begin), line.size());
    if (!number::parse_number(line.substr(begin, end - begin))) return false;
    begin = line.find_first_not_of(separators, end);
  }
  return any;
}

}  // namespace

std::string axis_name(int axis) { return std::string(axes.at(static_cast<std::size_t>(axis))); }

bundle::CsvDocument parse_coordinates(std::string_view text, const std::string& file_name) {
  const auto first = text.substr(0, text.find('\n'));
  if (has_numbers_only(first))
    throw Failure(
        Exit::input_output,
        fmt::format("{}:1: header is missing, the first line is data, \"{}\"; write x, or x,y, or x,y,z above "
                    "it, and separate numbers by commas, without brackets or blanks",
                    file_name, echo(first)));
  return bundle::parse_csv(text, file_name);
}

std::vector<std::size_t> axis_columns(const bundle::CsvDocument& csv) {
  std::vector<std::size_t> columns;
  for (const auto axis : axes) {
    const auto found = std::ranges::find(csv.header(), axis);
    if (found == csv.header().end()) break;
    columns.push_back(static_cast<std::size_t>(found - csv.header().begin()));
  }
  return columns;
}

void refuse_header(const bundle::CsvDocument& csv, const std::string& instead) {
  throw Failure(Exit::input_output, fmt::format("{}:1: header is \"{}\"; write {}", csv.file_name(),
                                                echo(fmt::format("{}", fmt::join(csv.header(), ","))), instead));
}

double number_at(const bundle::CsvDocument& csv, std::size_t row, std::size_t column) {
  const auto& text = csv.row(row)[column];
  const auto value = number::parse_number(text);
  if (!value || !std::isfinite(*value))
    throw Failure(Exit::input_output, fmt::format("{}:{}: row {}, column {}: \"{}\" {}", csv.file_name(), csv.line(row),
                                                  row + 1, csv.header()[column], echo(text), number::fault(text)));
  return *value;
}

}  // namespace bezierbench::cli
