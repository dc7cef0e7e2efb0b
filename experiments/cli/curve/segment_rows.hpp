// SPDX-License-Identifier: MIT
// Writes cubic Bezier segments as rows segment,index,x[,y[,z]], one control point per row.
#pragma once

#include <span>

namespace bezierbench::cli {

/// Writes a header and rows to standard output. `segments` has four control points per segment, point by point.
/// Segments and their points are numbered from 0.
void print_segments(std::span<const double> segments, int dimension);

}  // namespace bezierbench::cli
