// SPDX-License-Identifier: MIT
// The data that fits work on: scaled by a power of two, without repetitions.
#pragma once

#include <span>
#include <vector>

#include "core/powers.hpp"
#include "core/project/polygon.hpp"

namespace bezierbench {

template <int Dimension>
struct FitData {
  /// Takes at least one point, its finite `coordinates` point by point.
  explicit FitData(std::span<const double> coordinates) {
    const auto count = coordinates.size() / Dimension;
    const auto given = [&](std::size_t i) {
      Point<double, Dimension> point;
      for (int axis = 0; axis < Dimension; ++axis)
        point[axis] = coordinates[i * Dimension + static_cast<std::size_t>(axis)];
      return point;
    };
    double largest = 0;
    for (const double x : coordinates) largest = std::max(largest, std::abs(x));
    exponent = binary_exponent(largest);
    std::vector<std::size_t> kept;
    for (std::size_t i = 0; i < count; ++i) {
      if (kept.empty() || given(kept.back()) != given(i)) kept.push_back(i);
      index.push_back(static_cast<int>(kept.size()) - 1);
    }
    original.resize(Dimension, static_cast<Eigen::Index>(kept.size()));
    points.resize(Dimension, original.cols());
    for (Eigen::Index k = 0; k < original.cols(); ++k) {
      original.col(k) = given(kept[static_cast<std::size_t>(k)]);
      for (int axis = 0; axis < Dimension; ++axis) points(axis, k) = std::ldexp(original(axis, k), -exponent);
    }
    closed = original.cols() > 2 && original.col(0) == original.col(original.cols() - 1);
  }

  [[nodiscard]] int count() const { return static_cast<int>(points.cols()); }
  [[nodiscard]] int last() const { return count() - 1; }

  /// The largest change of a coordinate by scaling and scaling back, in scaled units. Only subnormal numbers change.
  [[nodiscard]] double quantum() const { return std::ldexp(1.0, std::max(-1073, -1073 - exponent)); }

  Polygon<Dimension> original;  ///< the given points without repetitions
  Polygon<Dimension> points;    ///< `original` over 2^exponent: at most 1 in magnitude
  std::vector<int> index;       ///< index of each given point in `points`
  int exponent = 0;
  bool closed = false;  ///< the last point equals the first
};

}  // namespace bezierbench
