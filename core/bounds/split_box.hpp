// SPDX-License-Identifier: MIT
// Formula: the curve is split at the computed parameters of its extrema, one after the other. Pieces whose control
//   points are outside the range of the known points by more than a bound E of all roundings are halved, up to eight
//   times; the box of all pieces' control points is widened on each side by E.
// Cost: that of the parameters, and 3 n(n+1)/2 d flops for each of them and for each halving.
// Bound: let M be max |b_i|. Exact pieces have their control points' hull around the curve, wherever it is split. A
//   step s a + t b, s the rounded 1-t, is off by at most 4u max(|a|, |b|) + 2 eta, and what a and b are off grows by at
//   most s + t <= 1 + u. With k splits of n steps, and kn < 2^40, every number is off by at most 5 k n (u M + eta) = E.
// Fails: where the polygon of a monotone piece still overshoots after eight halvings, the box is larger than by E.
#pragma once

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/bounds/extrema_parameters.hpp"

namespace bezierbench {

struct SplitBox {
  static constexpr BoxPromises promises{.contains = true, .within_one_ulp = false};
  static constexpr MethodInfo info{.id = "split_box",
                                   .label = "Split at the extrema, rounded outward",
                                   .problem = Problem::bounds,
                                   .promise = "contains the curve",
                                   .flops = "26n(n-1)d",
                                   .cost_exponent = 3,
                                   .citation = "[Farin 2002], subdivision; bound derived here"};

  static Range range(const PolynomialAxis& axis) {
    const int n = axis.degree();
    const Range ends = range_of_ends(axis);
    const Range polygon = range_of_control_points(axis);
    const double largest = std::max(std::abs(polygon.low), std::abs(polygon.high));
    constexpr double too_large = 0x1p1023;  // steps might overflow
    if ((ends.low == polygon.low && ends.high == polygon.high) || largest >= too_large) return polygon;
    std::vector<std::vector<double>> pieces{{axis.data(), axis.data() + n + 1}};
    Range box = ends;
    double from = 0;
    each_extremum(axis, [&](double t) {
      if (t <= from || t >= 1) return;
      auto [before, after] = split((t - from) / (1 - from), std::move(pieces.back()));
      box.include(after[0]);
      pieces.back() = std::move(before);
      pieces.push_back(std::move(after));
      from = t;
    });
    const double splits = static_cast<double>(pieces.size()) - 1 + most_halvings;
    const double off = 6 * splits * n * (0x1p-53 * largest + 0x1p-1073);  // above E in spite of its own roundings
    for (auto& piece : pieces) include(std::move(piece), most_halvings, off, box);
    // Where no control point is beyond the ends, these are the sides; and all control points contain the curve.
    return {polygon.low == ends.low ? ends.low : std::max(std::nextafter(box.low - off, whole_axis.low), polygon.low),
            polygon.high == ends.high ? ends.high
                                      : std::min(std::nextafter(box.high + off, whole_axis.high), polygon.high)};
  }

 private:
  static constexpr int most_halvings = 8;

  /// The parts before and after t.
  static std::pair<std::vector<double>, std::vector<double>> split(double t, std::vector<double> b) {
    const double s = 1 - t;
    std::vector<double> before{b[0]};
    for (std::size_t k = b.size() - 1; k > 0; --k) {
      for (std::size_t i = 0; i < k; ++i) b[i] = s * b[i] + t * b[i + 1];
      before.push_back(b[0]);
    }
    return {std::move(before), std::move(b)};
  }

  static void include(std::vector<double> b, int halvings, double off, Range& box) {
    const auto [low, high] = std::minmax_element(b.begin(), b.end());
    if (halvings == 0 || (*low >= box.low - off && *high <= box.high + off)) {
      box.include(*low);
      box.include(*high);
      return;
    }
    auto [left, right] = bernstein_halves(std::move(b));
    box.include(right[0]);
    include(std::move(left), halvings - 1, off, box);
    include(std::move(right), halvings - 1, off, box);
  }
};

}  // namespace bezierbench
