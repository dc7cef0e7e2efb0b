// SPDX-License-Identifier: MIT
// A whole B-spline curve or NURBS for the harness and the reference, and a view of what decides one of its knot spans.
#pragma once

#include <algorithm>
#include <cstddef>
#include <span>
#include <vector>

namespace bezierbench {

/// One knot span of a curve of degree m >= 1: the 2m knots and m + 1 control points that decide it (see
/// core/bspline/bspline.hpp). They stay in the caller's memory.
struct BsplineSpanView {
  int dimension = 2;
  int degree = 1;
  std::span<const double> knots;           ///< 2m
  std::span<const double> control_points;  ///< (m + 1) * dimension coordinates, point by point
  std::span<const double> weights = {};    ///< m + 1 of a rational curve, else none
};

/// Over t from knot number `degree` to the knot `degree` before the last one, of which the first is less.
struct BsplineCurve {
  int dimension = 2;
  int degree = 1;                      ///< at least 1
  std::vector<double> knots;           ///< degree + 1 more than control points, not descending
  std::vector<double> control_points;  ///< `dimension` coordinates each, point by point, not premultiplied
  std::vector<double> weights = {};    ///< one for each control point, positive; none of a polynomial curve

  [[nodiscard]] std::size_t points() const { return knots.size() - n() - 1; }
  [[nodiscard]] double begin() const { return knots[n()]; }
  [[nodiscard]] double end() const { return knots[points()]; }

  /// The number of the first knot of the span that t lies in: the last knot that is not behind t, unless the curve ends
  /// there.
  [[nodiscard]] std::size_t span_at(double t) const {
    const auto first = knots.begin() + degree;
    const auto last = knots.end() - degree - 1;
    const auto next = t < *last ? std::upper_bound(first, last, t) : std::lower_bound(first, last, *last);
    return static_cast<std::size_t>(next - knots.begin()) - 1;
  }

  /// The span that begins with knot number `first`.
  [[nodiscard]] BsplineSpanView span(std::size_t first) const {
    const auto d = static_cast<std::size_t>(dimension);
    const std::size_t point = first - n();
    return {dimension, degree, std::span(knots).subspan(point + 1, 2 * n()),
            std::span(control_points).subspan(point * d, (n() + 1) * d),
            std::span(weights).subspan(weights.empty() ? 0 : point, weights.empty() ? 0 : n() + 1)};
  }

 private:
  [[nodiscard]] std::size_t n() const { return static_cast<std::size_t>(degree); }
};

}  // namespace bezierbench
