// SPDX-License-Identifier: MIT
// The methods for boxes behind function pointers.
#pragma once

#include <span>

#include "core/bounds/bounds.hpp"
#include "core/curve_view.hpp"
#include "core/method.hpp"

namespace bezierbench {

/// One method, for curves of one dimension.
struct BoundsKernel {
  const MethodInfo* info;
  const BoxPromises* promises;
  int dimension;
  /// Writes the lowest and the highest coordinate of each axis, 2 `dimension` numbers. The curve has the form of `info`
  /// and finite numbers.
  void (*box)(const CurveView<double>& curve, double* sides);
};

/// All methods, in roster order. Dimension is 1, 2 or 3.
std::span<const BoundsKernel> bounds_kernels(int dimension);

}  // namespace bezierbench
