// SPDX-License-Identifier: MIT
// Point files, CSV with a header that names the axes in any order and one point per row, and the segments that commands
// compute from them.
#pragma once

#include <cstddef>
#include <filesystem>
#include <span>
#include <vector>

namespace bezierbench::cli {

struct PointFile {
  int dimension = 0;
  std::vector<double> coordinates;  ///< point by point
  std::vector<std::size_t> lines;   ///< of the file, one for each point

  [[nodiscard]] std::size_t count() const { return coordinates.size() / static_cast<std::size_t>(dimension); }
};

/// Reads points. Throws Failure(input_output) that names file, row and column for anything but finite numbers under a
/// valid header, for fewer than `least` points, and for a file that cannot be read.
PointFile read_points(const std::filesystem::path& file, std::size_t least);

/// Writes cubic Bezier segments to standard output as rows segment,index,x[,y[,z]] below a header, one control point per row.
/// `segments` has four control points per segment, point by point. Segments and their points are numbered from 0.
void print_segments(std::span<const double> segments, int dimension);

}  // namespace bezierbench::cli
