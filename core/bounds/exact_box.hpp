// SPDX-License-Identifier: MIT
// Formula: the curve is halved without rounding. A piece whose inner control points are all at or above the lowest
//   value that is known is dropped; the lowest control point of those that remain, rounded down, is the low side. The
//   high side is that of -p. It ends where at most one double separates the side from the lowest known value.
// Source: integers without rounding as here are our own.
// Cost: a halving takes n(n+1)/2 sums of integers that grow by n bits; about 27 halvings of two pieces an extremum.
// Bound: the side is below every control point of every piece, and so below the curve; a point of the curve lies below
//   the second next double. So it is the tightest double or the next one. A rational curve: the same with N and W as
//   integers and the quotients of control points; weights of both signs give an infinite box.
// Fails: it takes microseconds. The search of a minimum at or next to 0 may halve some 540 times.
#pragma once

#include <span>

#include "core/bounds/bounds.hpp"

namespace bezierbench {

/// The side of the box below the curve with the finite control points `b`. `weights` are those of a rational curve, of
/// one sign and not all 0, else none.
double exact_low_side(std::span<const double> b, std::span<const double> weights);

template <Form F>
struct ExactBox {
  static constexpr BoxPromises promises{.contains = true, .within_one_ulp = true};
  static constexpr MethodInfo info{.id = "exact_box",
                                   .label = "Halved without rounding, rounded outward once",
                                   .problem = Problem::bounds,
                                   .form = F,
                                   .max_degree = 100,
                                   .max_degree_float = 100,
                                   .promise = "contains the curve, each side at most 1 ulp beyond the tightest",
                                   .flops = "54n(n+1)d",
                                   .cost_exponent = 2,
                                   .citation = "[Lane and Riesenfeld 1981]"};

  static Range range(const Curve<F, double, 1>& axis) {
    const auto ends = range_of_ends(axis);
    const auto polygon = range_of_control_points(axis);
    if (polygon.high == whole_axis.high) return whole_axis;
    auto b = control_points(axis);
    const std::span<const double> points(b.data(), static_cast<std::size_t>(axis.degree()) + 1);
    std::span<const double> weights;
    if constexpr (F == Form::rational) weights = {axis.weights.data(), points.size()};
    Range range = polygon;
    if (polygon.low < ends.low) range.low = exact_low_side(points, weights);
    if (polygon.high > ends.high) {
      for (int i = 0; i <= axis.degree(); ++i) b(0, i) = -b(0, i);
      range.high = 0 - exact_low_side(points, weights);  // never -0
    }
    return range;
  }
};

}  // namespace bezierbench
