// SPDX-License-Identifier: MIT
// The methods for arc lengths behind function pointers.
#pragma once

#include <cstdint>
#include <limits>
#include <span>

#include "core/curve_view.hpp"
#include "core/method.hpp"

namespace bezierbench {

/// A length, with the method's estimate of its error.
struct ArcLength {
  double length = 0;
  double error_estimate = std::numeric_limits<double>::quiet_NaN();  ///< absolute; NaN if the method has none
  std::int64_t evaluations = 0;                                      ///< of the speed or, for chords, the curve
  bool converged = false;  ///< error_estimate is at most tolerance times the length
};

/// One method, for Bezier curves of one dimension and the form of its `info`.
struct ArcLengthKernel {
  const MethodInfo* info;
  int dimension;
  /// The length of the part of `curve` between the parameters 0 <= from <= to <= 1, up to `tolerance` > 0 times that
  /// length. Sizes are scaled by a power of two first, so that results do not depend on the size of the coordinates.
  ArcLength (*measure)(const CurveView<double>& curve, double from, double to, double tolerance);
};

/// The length of a whole curve in the Bernstein or rational form, by the method that is best at it.
double whole_length(const CurveView<double>& curve);

/// All methods, in roster order. Dimension is 1, 2 or 3.
std::span<const ArcLengthKernel> arc_length_kernels(int dimension);

}  // namespace bezierbench
