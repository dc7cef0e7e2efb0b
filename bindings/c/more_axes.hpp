// SPDX-License-Identifier: MIT
// Curves of 4 or 5 axes, such as points with a colour: axes are independent of each other, so that up to three at a time
// are a curve of their own.
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

#include "bindings/c/curve.hpp"

namespace bezierbench::c {

inline constexpr int max_dimension_of_points = 5;

/// Whether the curve has more axes than kernels take, and a number of them that by_axes() takes.
inline bool has_more_axes(const bb_curve* curve) {
  return curve != nullptr && curve->dimension > max_dimension && curve->dimension <= max_dimension_of_points;
}

/// Answers `curve`, which has more axes, by answers for some of its axes: `answer(part, out)` writes `rows` points of the
/// curve `part` and returns a status. Writes to `out`, point by point, after the last answer. Throws Refused for the
/// first status that is not BB_OK.
template <class Answer>
void by_axes(const bb_curve& curve, std::size_t rows, double* out, const Answer& answer) {
  require_shape(max_dimension, curve.degree);
  require_pointers(curve.points);
  const auto d = static_cast<std::size_t>(curve.dimension);
  const std::size_t control_points = static_cast<std::size_t>(curve.degree) + 1;
  std::vector<double> all(rows * d);
  for (std::size_t first = 0; first < d; first += max_dimension) {
    const std::size_t width = std::min(d - first, std::size_t{max_dimension});
    const auto copy = [width](const double* from, std::size_t from_step, double* to, std::size_t to_step,
                              std::size_t count) {
      for (std::size_t k = 0; k < count; ++k) std::copy_n(from + k * from_step, width, to + k * to_step);
    };
    std::vector<double> points(control_points * width);
    copy(curve.points + first, d, points.data(), width, control_points);
    std::vector<double> answered(rows * width);
    const bb_curve part{curve.form, static_cast<int>(width), curve.degree, points.data(), curve.weights};
    const int status = answer(part, answered.data());
    require(status == BB_OK, static_cast<bb_status>(status));
    copy(answered.data(), width, all.data() + first, d, rows);
  }
  if (all.empty()) return;
  require_pointers(out);
  std::ranges::copy(all, out);
}

}  // namespace bezierbench::c
