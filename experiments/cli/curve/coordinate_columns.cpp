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

}  // namespace

std::string axis_name(int axis) { return std::string(axes.at(static_cast<std::size_t>(axis))); }

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
    throw Failure(Exit::input_output,
                  fmt::format("{}:{}: row {}, column {}: \"{}\" is not a finite number; write a "
                              "decimal or hexadecimal double",
                              csv.file_name(), csv.line(row), row + 1, csv.header()[column], echo(text)));
  return *value;
}

}  // namespace bezierbench::cli
