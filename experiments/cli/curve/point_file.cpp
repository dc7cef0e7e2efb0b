// SPDX-License-Identifier: MIT
#include "experiments/cli/curve/point_file.hpp"

#include <fmt/format.h>

#include <cstdio>
#include <iterator>
#include <string>

#include "experiments/bundle/atomic_file.hpp"
#include "experiments/cli/curve/coordinate_columns.hpp"
#include "experiments/failure.hpp"
#include "experiments/number/number.hpp"

namespace bezierbench::cli {

PointFile read_points(const std::filesystem::path& file, std::size_t least) {
  const auto csv = parse_coordinates(bundle::read_file(file), file.string());
  const auto columns = axis_columns(csv);
  if (columns.empty() || columns.size() != csv.header().size()) refuse_header(csv, "x, or x,y, or x,y,z");
  if (csv.row_count() < least)
    throw Failure(Exit::input_output, fmt::format("{}: {} point{}; write {} or more, one per row", file.string(),
                                                  csv.row_count(), csv.row_count() == 1 ? "" : "s", least));
  PointFile points{static_cast<int>(columns.size()), {}, {}};
  points.coordinates.reserve(csv.row_count() * columns.size());
  for (std::size_t row = 0; row < csv.row_count(); ++row) {
    for (const auto column : columns) points.coordinates.push_back(number_at(csv, row, column));
    points.lines.push_back(csv.line(row));
  }
  return points;
}

void print_segments(std::span<const double> segments, int dimension) {
  constexpr std::size_t enough = 1U << 20U;  // bytes; rows are written in portions of about this size
  std::string text = "segment,index";
  for (int axis = 0; axis < dimension; ++axis) text += "," + axis_name(axis);
  text += "\n";
  const auto d = static_cast<std::size_t>(dimension);
  for (std::size_t point = 0; point < segments.size() / d; ++point) {
    fmt::format_to(std::back_inserter(text), "{},{}", point / 4, point % 4);
    for (const double value : segments.subspan(point * d, d)) text += "," + number::decimal(value);
    text += "\n";
    if (text.size() < enough) continue;
    fmt::print("{}", text);
    text.clear();
  }
  fmt::print("{}", text);
}

}  // namespace bezierbench::cli
