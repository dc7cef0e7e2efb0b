// SPDX-License-Identifier: MIT
// Kinds of data for fits. Each kind computes the data points from a drawn Bezier curve and one drawn displacement per
// data point, by arithmetic without libm, so that no bit depends on the machine.
#pragma once

#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "experiments/sample/draw.hpp"

namespace bezierbench::sample {

/// The drawn numbers that data are made of, point by point.
struct DataSource {
  int dimension = 0;
  int degree = 1;  ///< at least 1
  std::vector<double> control_points;
  std::vector<double> displacements;  ///< one for each data point, two or more, drawn like control points
};

struct DataKind {
  std::string_view id;
  std::string_view what;
  std::vector<double> (*make)(DataSource source);
};

/// All kinds.
std::span<const DataKind> data_kinds();

/// The data of trial `trial`, point by point. `sampler` draws the cell that with_displacements() returns.
std::vector<double> data_points(const DataKind& kind, const Sampler& sampler, const Cell& cell, std::uint64_t trial);

/// The cell whose curves have `points` more control points, which become the displacements.
Cell with_displacements(Cell cell, int points);

}  // namespace bezierbench::sample
