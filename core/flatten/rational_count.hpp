// SPDX-License-Identifier: MIT
// Formula: with C = V / W, c the middle of the box of the control points, v_i = w_i (b_i - c) and r the largest
//   |b_i - c|, m = ceil(sqrt(n (n-1) (max |D^2 v| + r max |D^2 w|) / (8 E min |w_i|))) chords between points at k/m.
// Source: the count is derived here.
// Bound: let V' and W' be the linear functions that equal V and W at the ends of a piece over [a, a + h]. V'/W' is on
//   the chord, so |V'/W'| <= r about c, and V/W - V'/W' = (V - V') / W + (V'/W') (W' - W) / W is at most
//   h^2/8 (max |V''| + r max |W''|) / min |W|. So the tolerance is kept, apart from roundings.
// Fails: the smallest weight decides everywhere. Weights of two signs leave no bound of |W|: as many chords as there
//   may be, and not complete.
#pragma once

#include <algorithm>

#include "core/evaluate/homogeneous.hpp"
#include "core/flatten/wang_count.hpp"
#include "core/homogeneous_coordinates.hpp"
#include "core/powers.hpp"

namespace bezierbench {

struct RationalCount {
  static constexpr MethodInfo info{.id = "zheng_sederberg_count",
                                   .label = "Equal steps by Zheng and Sederberg's bound",
                                   .problem = Problem::flattening,
                                   .form = Form::rational,
                                   .min_degree = 1,
                                   .promise = WangCount::info.promise,
                                   .flops = "n(1+3(d+1)) + 1 + d",
                                   .citation = "[Zheng and Sederberg 2000]"};

  template <int Dimension, int Degree>
  static void flatten(const Curve<Form::rational, double, Dimension, Degree>& curve, double tolerance,
                      Flattening& chords) {
    add_equal_steps<Homogeneous<HornerBernstein>>(curve, curve.points, wanted(curve, tolerance), chords);
  }

 private:
  template <int Dimension, int Degree>
  static double wanted(const Curve<Form::rational, double, Dimension, Degree>& curve, double tolerance) {
    const int n = curve.degree();
    if (!weights_have_one_sign(curve) || !weights_are_in_range(curve)) return std::numeric_limits<double>::infinity();
    double largest_weight = 0;
    for (int i = 0; i <= n; ++i) largest_weight = std::max(largest_weight, std::abs(curve.weights[i]));
    const int exponent = binary_exponent(largest_weight);
    auto v = curve.points;
    double radius = 0;
    Point<double, Dimension> middle;
    for (int axis = 0; axis < Dimension; ++axis) {
      double low = curve.points(axis, 0);
      double high = low;
      for (int i = 1; i <= n; ++i) {
        low = std::min(low, curve.points(axis, i));
        high = std::max(high, curve.points(axis, i));
      }
      middle[axis] = 0.5 * low + 0.5 * high;
    }
    Curve<Form::bernstein, double, 1, Degree> w(n);
    double least = std::numeric_limits<double>::infinity();
    for (int i = 0; i <= n; ++i) {
      w(0, i) = std::abs(times_power_of_two(curve.weights[i], -exponent));
      least = std::min(least, w(0, i));
      const Point<double, Dimension> offset = control_point(curve.points, i) - middle;
      radius = std::max(radius, offset.norm());
      for (int axis = 0; axis < Dimension; ++axis) v(axis, i) = w(0, i) * offset[axis];
    }
    const double second = largest_second_derivative(v) + radius * largest_second_derivative(w);
    return std::max(std::ceil(std::sqrt(second / least / tolerance * 0.125)), 1.0);
  }
};

}  // namespace bezierbench
