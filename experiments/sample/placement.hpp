// SPDX-License-Identifier: MIT
// Placements of the point that is projected onto a curve. Each takes a drawn curve and a point that is drawn like its
// control points, and moves one or both, by arithmetic without libm, so that no bit depends on the machine.
#pragma once

#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "experiments/sample/draw.hpp"

namespace bezierbench::sample {

/// A curve with control points and a point with as many coordinates.
struct ProjectionCase {
  int dimension = 0;
  int degree = 0;
  std::vector<double> points;  ///< point by point
  std::vector<double> point;
  std::vector<double> weights;  ///< of a rational curve
};

/// The largest |coordinate| of the control points and the point.
double largest_coordinate(const ProjectionCase& problem);

struct Placement {
  std::string_view id;
  std::string_view what;
  void (*place)(ProjectionCase& problem, double t);
  bool is_rational = false;  ///< whether it places points for rational curves, too
};

/// All placements.
std::span<const Placement> placements();
/// Those for curves of a form.
std::vector<std::string_view> placement_ids(Form form);

/// Trial `trial` of the cell. The point is placed relative to the parameter that is drawn with the curve. Both stay as
/// they are drawn where the placement leaves the range of double: `cusp` moves a control point by up to 2^n R. `sampler`
/// draws the cell that with_point() returns, of one degree more: its last control point is the drawn point.
ProjectionCase place(const Placement& placement, const Sampler& sampler, const Cell& cell, std::uint64_t trial);

/// The cell whose curves have one more control point, which serves as the point.
Cell with_point(Cell cell);

}  // namespace bezierbench::sample
