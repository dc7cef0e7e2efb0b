// SPDX-License-Identifier: MIT
// The methods for points on grids behind function pointers.
#pragma once

#include <span>

#include "core/bound/grid_bound.hpp"
#include "core/curve_view.hpp"
#include "core/method.hpp"

namespace bezierbench {

/// One method, for curves of one dimension.
struct GridKernel {
  const MethodInfo* info;
  const GridBound* bound;
  int dimension;
  /// Writes the (steps + 1) `dimension` coordinates of the points at k/steps, point by point; `steps` is a power of two
  /// up to max_grid_steps.
  void (*points)(const CurveView<double>& curve, int steps, double* coordinates);
};

/// All methods, in roster order. Dimension is 1, 2 or 3.
std::span<const GridKernel> grid_kernels(int dimension);

}  // namespace bezierbench
