// SPDX-License-Identifier: MIT
#include "experiments/cli/curve_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "experiments/bundle/atomic_file.hpp"
#include "experiments/bundle/csv.hpp"
#include "experiments/failure.hpp"
#include "experiments/number/number.hpp"

namespace bezierbench::cli {
namespace {

constexpr std::array<std::string_view, 3> axes{"x", "y", "z"};

/// How many axes the header names: x | x,y | x,y,z.
int dimension_of(const bundle::CsvDocument& csv) {
  const auto& header = csv.header();
  if (header.size() > 1 && header.back() == "w")
    throw Failure(Exit::usage,
                  fmt::format("{}:1: weights (column w) are not available yet; leave the column out", csv.file_name()));
  const bool good = header.size() <= axes.size() && std::equal(header.begin(), header.end(), axes.begin());
  if (!good)
    throw Failure(Exit::input_output, fmt::format("{}:1: header is \"{}\"; write x, or x,y, or x,y,z", csv.file_name(),
                                                  fmt::join(header, ",")));
  return static_cast<int>(header.size());
}

}  // namespace

std::string axis_name(int axis) { return std::string(axes.at(static_cast<std::size_t>(axis))); }

CurveFile read_curve(const std::filesystem::path& file, Form form) {
  const auto csv = bundle::parse_csv(bundle::read_file(file), file.string());
  CurveFile curve{form, dimension_of(csv), {}};
  if (csv.row_count() == 0)
    throw Failure(Exit::input_output, fmt::format("{}: no coefficients; write one per row", file.string()));
  if (csv.row_count() > static_cast<std::size_t>(max_degree) + 1)
    throw Failure(Exit::input_output, fmt::format("{}: {} coefficients; the largest degree is {}", file.string(),
                                                  csv.row_count(), max_degree));
  for (std::size_t row = 0; row < csv.row_count(); ++row)
    for (std::size_t column = 0; column < csv.header().size(); ++column) {
      const auto& text = csv.row(row)[column];
      const auto value = number::parse_number(text);
      if (!value || !std::isfinite(*value))
        throw Failure(Exit::input_output,
                      fmt::format("{}:{}: row {}, column {}: \"{}\" is not a finite number; write a "
                                  "decimal or hexadecimal double",
                                  file.string(), csv.line(row), row + 1, csv.header()[column], text));
      curve.coefficients.push_back(*value);
    }
  return curve;
}

std::string curve_csv(const CurveFile& curve) {
  std::vector<std::string> header;
  for (int axis = 0; axis < curve.dimension; ++axis) header.push_back(axis_name(axis));
  bundle::CsvTable table(header);
  for (int i = 0; i <= curve.degree(); ++i) {
    std::vector<std::string> row;
    for (int axis = 0; axis < curve.dimension; ++axis) row.push_back(number::decimal(curve.view()(axis, i)));
    table.add_row(std::move(row));
  }
  return table.text();
}

}  // namespace bezierbench::cli
