// SPDX-License-Identifier: MIT
// The named curves of exhaustive studies: named_curves.csv beside this file, which is embedded in the program.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/curve_view.hpp"

namespace bezierbench::studies {

/// A Bezier curve of floats.
struct NamedCurve {
  std::string id;
  int dimension = 1;
  std::vector<float> control_points;  ///< point by point; the decimals of the file, as doubles, rounded to float

  [[nodiscard]] int degree() const { return static_cast<int>(control_points.size()) / dimension - 1; }
  [[nodiscard]] CurveView<float> view() const { return {Form::bernstein, dimension, degree(), control_points}; }
  /// The coordinates of one axis.
  [[nodiscard]] std::vector<float> axis(int axis) const;
};

/// The text of named_curves.csv.
std::string_view named_curves_text();

/// Its curves, in its order.
const std::vector<NamedCurve>& named_curves();

}  // namespace bezierbench::studies
