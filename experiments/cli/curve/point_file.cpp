// SPDX-License-Identifier: MIT
#include "experiments/cli/curve/point_file.hpp"

#include <fmt/format.h>

#include "experiments/bundle/atomic_file.hpp"
#include "experiments/cli/curve/coordinate_columns.hpp"
#include "experiments/failure.hpp"

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

}  // namespace bezierbench::cli
