// SPDX-License-Identifier: MIT
// Writes cubic Bezier segments as rows segment,index,x[,y[,z]], one control point per row.
#pragma once

#include <span>

namespace bezierbench::cli {

/// Writes header and rows to standard output. `segments` are the coordinates of four control points per segment, point
/// by point; segments and the points of each count from 0.
void print_segments(std::span<const double> segments, int dimension);

}  // namespace bezierbench::cli
