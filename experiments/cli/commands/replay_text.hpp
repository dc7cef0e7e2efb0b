// SPDX-License-Identifier: MIT
// The numbers of an input, as `replay` prints them.
#pragma once

#include <fmt/format.h>

#include <string>

#include "core/curve_view.hpp"
#include "experiments/cli/curve/coordinate_columns.hpp"
#include "experiments/number/number.hpp"

namespace bezierbench::cli {

/// The number in hexadecimal, which keeps all bits, and in decimal.
inline std::string both(double value) {
  return fmt::format("{} ({})", number::hexadecimal(value), number::decimal(value));
}

/// A line for each coordinate of each coefficient.
template <class Scalar>
void print_points(const CurveView<Scalar>& curve) {
  for (int i = 0; i <= curve.degree; ++i)
    for (int axis = 0; axis < curve.dimension; ++axis)
      fmt::print("  {}[{}]{:<7}{}\n", axis_name(axis), i, "", both(static_cast<double>(curve(axis, i))));
}

}  // namespace bezierbench::cli
