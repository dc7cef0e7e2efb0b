// SPDX-License-Identifier: MIT
// A Bezier curve of floats, as exhaustive studies evaluate it.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/curve_view.hpp"

namespace bezierbench::studies {

struct FloatCurve {
  /// The coefficients are rounded to float.
  FloatCurve(std::string_view of_set, std::string_view name, const CurveView<double>& curve)
      : set(of_set),
        id(name),
        dimension(curve.dimension),
        control_points(curve.coefficients.begin(), curve.coefficients.end()) {}

  std::string set;  ///< id of its curve set
  std::string id;
  int dimension;
  std::vector<float> control_points;  ///< point by point

  [[nodiscard]] int degree() const { return static_cast<int>(control_points.size()) / dimension - 1; }
  [[nodiscard]] CurveView<float> view() const { return {Form::bernstein, dimension, degree(), control_points}; }
  /// The coordinates of one axis.
  [[nodiscard]] std::vector<float> axis(int axis) const {
    std::vector<float> coordinates;
    for (int i = 0; i <= degree(); ++i) coordinates.push_back(view()(axis, i));
    return coordinates;
  }
};

}  // namespace bezierbench::studies
