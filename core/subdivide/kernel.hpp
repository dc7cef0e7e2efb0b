// SPDX-License-Identifier: MIT
// The methods for subdivision behind function pointers.
#pragma once

#include <span>

#include "core/curve_view.hpp"
#include "core/method.hpp"
#include "core/subdivide/subdivision.hpp"

namespace bezierbench {

/// One method, for curves of one dimension.
struct SplitKernel {
  const MethodInfo* info;
  const SplitPromises* promises;
  const SplitBound* bound;  ///< nullptr where nothing is proved
  int dimension;
  /// Splits `curve`, of the form of `info`, at finite t. Writes degree + 1 control points of
  /// `split_columns(form, dimension)` numbers to each half, point by point.
  void (*split)(const CurveView<double>& curve, double t, double* left, double* right);
};

/// The number of columns of a control point of a half: its coordinates, not premultiplied, and for a rational curve its
/// weight.
constexpr int split_columns(Form form, int dimension) { return form == Form::rational ? dimension + 1 : dimension; }

/// All methods, in roster order. Dimension is 1, 2 or 3.
std::span<const SplitKernel> split_kernels(int dimension);

}  // namespace bezierbench
