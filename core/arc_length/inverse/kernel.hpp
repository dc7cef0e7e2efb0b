// SPDX-License-Identifier: MIT
// The methods for inverse arc length behind function pointers.
#pragma once

#include <span>

#include "core/arc_length/inverse/result.hpp"
#include "core/curve_view.hpp"
#include "core/method.hpp"

namespace bezierbench {

/// One method, for Bezier curves of one dimension.
struct InverseArcLengthKernel {
  const MethodInfo* info;
  int dimension;
  /// The parameter at which the length of `curve` from its beginning is `target`, up to `tolerance` > 0 times the
  /// length of the curve. Sizes are scaled by a power of two first, so that results do not depend on the size of the
  /// coordinates. For a curve that is a point the result is 0, converged if `target` is 0.
  InverseArcLength (*solve)(const CurveView<double>& curve, double target, double tolerance);
};

/// All methods, in roster order. Dimension is 1, 2 or 3.
std::span<const InverseArcLengthKernel> inverse_arc_length_kernels(int dimension);

/// The infos of all methods, in roster order.
std::span<const MethodInfo* const> inverse_arc_length_infos();

}  // namespace bezierbench
