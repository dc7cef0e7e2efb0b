// SPDX-License-Identifier: MIT
// What a generator can draw. A study is checked against it when it is read, before any run begins.
#pragma once

#include "core/curve_view.hpp"

namespace bezierbench::suite {

struct GeneratorLimits {
  bool weights = false;      ///< it draws weights, so it is for rational curves only
  bool whole_curve = false;  ///< the coefficients of a curve are drawn together, not point by point
  int bezier_degree = max_degree;
  int polynomial_degree = max_degree;
  double smallest_range = 0;
  double largest_range = 0x1p+1020;  ///< norms and second differences of points are in range
  bool finite_width = false;         ///< t_max - t_min must not overflow
  /// The coefficients are exactly those of an intended polynomial. This needs R to be a power of two and the scalar to
  /// be double.
  bool exact_coefficients = false;
};

}  // namespace bezierbench::suite
