// SPDX-License-Identifier: MIT
// The methods for derivatives behind function pointers.
#pragma once

#include <span>

#include "core/bound/derivative_bound.hpp"
#include "core/curve_view.hpp"
#include "core/method.hpp"

namespace bezierbench {

/// One method, for curves of one dimension.
struct DerivativeKernel {
  const MethodInfo* info;
  const DerivativeBound* bound;  ///< nullptr where nothing is proved
  int dimension;
  /// Writes the `dimension` coordinates of the derivative of `order` >= 0 at t.
  void (*derivative)(const CurveView<double>& curve, int order, double t, double* coordinates);
};

/// All methods, in roster order. Dimension is 1, 2 or 3.
std::span<const DerivativeKernel> derivative_kernels(int dimension);

}  // namespace bezierbench
