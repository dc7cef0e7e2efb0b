// SPDX-License-Identifier: MIT
// Formula: the C2 natural cubic spline by its handles P1,i:
//   2 P1,0 + P1,1 = K_0 + 2 K_1,  P1,(i-1) + 4 P1,i + P1,(i+1) = 4 K_i + 2 K_(i+1),
//   2 P1,(n-2) + 7 P1,(n-1) = 8 K_(n-1) + K_n,
//   then P2,i = 2 K_(i+1) - P1,(i+1) and P2,(n-1) = (K_n + P1,(n-1)) / 2.
// Source: the document's system is right. Its last formula, P2,i = 2 K_i - P1,i, has both indices on the right too low
//   by one; it is corrected here. A single segment, for which it has no equation, is straight.
// Bound: none; the solution is not refined.
// Fails: far from the origin: handles have the size of the points, so that they lose the digits in which neighbouring
//   points differ.
#pragma once

#include "core/interpolate/interpolation.hpp"

namespace bezierbench {

struct C2NaturalHandles {
  static constexpr MethodInfo info{.id = "c2_natural_handles",
                                   .label = "C2 natural spline by its handles",
                                   .problem = Problem::interpolation,
                                   .form = Form::bernstein,
                                   .min_degree = 3,
                                   .max_degree = 3,
                                   .flops = "per point 9d",
                                   .citation = "[Document 003], corrected"};

  static constexpr double residual_bound = 0;

  static InnerPoints inner_points(std::span<const double> k) {
    const std::size_t n = k.size() - 1;
    if (n == 1) return {{(2 * k[0] + k[1]) / 3}, {(k[0] + 2 * k[1]) / 3}};
    InnerPoints points{right_hand_sides(k), std::vector<double>(n)};
    spline_system::solve(points.first, 3.5);
    for (std::size_t i = 0; i + 1 < n; ++i) points.second[i] = 2 * k[i + 1] - points.first[i + 1];
    points.second[n - 1] = (k[n] + points.first[n - 1]) / 2;
    return points;
  }

 private:
  /// The right-hand sides. The last equation is divided by 2.
  static std::vector<double> right_hand_sides(std::span<const double> k) {
    const std::size_t n = k.size() - 1;
    std::vector<double> right(n);
    right[0] = k[0] + 2 * k[1];
    for (std::size_t i = 1; i + 1 < n; ++i) right[i] = 4 * k[i] + 2 * k[i + 1];
    right[n - 1] = 4 * k[n - 1] + k[n] / 2;
    return right;
  }
};

}  // namespace bezierbench
