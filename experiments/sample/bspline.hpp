// SPDX-License-Identifier: MIT
// Generator `bspline`: one knot span of a random B-spline curve in Bernstein form, as a program has it that evaluates
// B-spline curves span by span. Neighbouring control points are closer to each other than random ones.
//
// With the knots u_0..u_(2n-1) of one of the kinds of knots and the span from a = u_(n-1) to c = u_n, control point k
// is the blossom of the curve at n-k times a, then k times c. Level r = 1..n of its triangle, for the r-th argument x,
// makes
//   d_i = ((u_(i+n) - x) d_i + (x - u_(i+r-1)) d_(i+1)) / (u_(i+n) - u_(i+r-1)),    i = 0..n-r
// in double; both weights are quotients of their own. What results is the curve, exactly.
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

#include "experiments/sample/independent_points.hpp"
#include "experiments/sample/knot_kind.hpp"

namespace bezierbench::sample {

/// Takes two words for t, two for the kind of knots, those of the knots, then two for each coordinate of the control
/// points of the B-spline curve.
struct Bspline {
  static constexpr GeneratorInfo info{
      .id = "bspline",
      .coordinates = "of the Bernstein form of a knot span of a B-spline curve, whose control points are as continuous",
      .t = "as continuous",
      .limits = {.whole_curve = true, .bezier_degree = 50, .polynomial_degree = 0}};

  static double parameter(Words& words, suite::Interval t) { return Continuous::parameter(words, t); }

  static void rounded_curve(Words& words, int dimension, double range, std::span<double> coordinates) {
    const auto d = static_cast<std::size_t>(dimension);
    const std::size_t n = coordinates.size() / d - 1;
    const KnotKind& kind = knot_kinds()[words.next_below(knot_kinds().size())];
    const auto knots = n > 0 ? draw_knots(kind, static_cast<int>(n), words) : std::vector<double>{};
    for (double& coordinate : coordinates) coordinate = Continuous::coordinate(words, range);
    const std::vector<double> spline(coordinates.begin(), coordinates.end());
    for (std::size_t axis = 0; axis < d; ++axis)
      for (std::size_t k = 0; k <= n; ++k) {
        std::vector<double> one_axis;
        for (std::size_t i = 0; i <= n; ++i) one_axis.push_back(spline[i * d + axis]);
        coordinates[k * d + axis] = std::clamp(blossom(knots, k, std::move(one_axis)), -range, range);
      }
  }

 private:
  /// The value at n - k times the begin of the span and k times its end.
  static double blossom(std::span<const double> knots, std::size_t k, std::vector<double> d) {
    const std::size_t n = d.size() - 1;
    for (std::size_t r = 1; r <= n; ++r) {
      const double x = r <= n - k ? knots[n - 1] : knots[n];
      for (std::size_t i = 0; i + r <= n; ++i) {
        const double left = knots[i + r - 1];
        const double right = knots[i + n];
        d[i] = (right - x) / (right - left) * d[i] + (x - left) / (right - left) * d[i + 1];
      }
    }
    return d[0];
  }
};

}  // namespace bezierbench::sample
