// SPDX-License-Identifier: MIT
// Point files: CSV with a header that names the axes, in any order; one point per row.
#pragma once

#include <cstddef>
#include <filesystem>
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

}  // namespace bezierbench::cli
