// SPDX-License-Identifier: MIT
// The methods for roots behind function pointers.
#pragma once

#include <span>

#include "core/curve_view.hpp"
#include "core/roots/roots.hpp"

namespace bezierbench {

/// One method.
struct RootsKernel {
  const MethodInfo* info;
  /// Where a coordinate of the curve, in Bernstein form and with finite numbers, is `value`, which is finite.
  FoundRoots (*find)(const CurveView<double>& curve, int axis, double value);
};

/// All methods, in roster order.
std::span<const RootsKernel> roots_kernels();

}  // namespace bezierbench
