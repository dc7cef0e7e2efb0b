// SPDX-License-Identifier: MIT
// The methods for flattening behind function pointers.
#pragma once

#include <span>

#include "core/curve_view.hpp"
#include "core/flatten/flattening.hpp"
#include "core/method.hpp"

namespace bezierbench {

/// One method, for curves of one dimension.
struct FlattenKernel {
  const MethodInfo* info;
  int dimension;
  bool keeps_tolerance;  ///< promises the tolerance for what was computed, roundings included, where it says `complete`
  bool reverses;         ///< promises the same points for the reversed curve
  /// Overwrites `chords`. The tolerance is above 0; control points are finite.
  void (*flatten)(const CurveView<double>& curve, double tolerance, Flattening& chords);
};

/// All methods, in roster order. Dimension is 1, 2 or 3.
std::span<const FlattenKernel> flatten_kernels(int dimension);

}  // namespace bezierbench
