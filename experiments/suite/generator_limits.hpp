// SPDX-License-Identifier: MIT
// What a generator can draw, as data: studies are held to it when they are read, so that none is run for nothing.
#pragma once

#include <limits>

#include "core/curve_view.hpp"

namespace bezierbench::suite {

struct GeneratorLimits {
  bool weights = false;  ///< draws weights: for rational curves, and for no others
  int bezier_degree = max_degree;
  int polynomial_degree = max_degree;
  double smallest_range = 0;
  double largest_range = std::numeric_limits<double>::max();
  bool finite_width = false;  ///< t_max - t_min must not overflow
  /// The coefficients are those of an intended polynomial, to the last bit: R is a power of two, the scalar double.
  bool exact_coefficients = false;
};

}  // namespace bezierbench::suite
