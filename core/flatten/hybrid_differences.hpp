// SPDX-License-Identifier: MIT
// Formula: a piece of a cubic in the basis e_0 = p_0, e_1 = p_3 - p_0, e_2 = 6 (p_1 - 2 p_2 + p_3),
//   e_3 = 6 (p_0 - 2 p_1 + p_2), the second derivatives at its end and start. Halving: e_3 /= 4, e_2 = (e_2 + e_3') / 2
//   with e_2 / 4 in it, e_1 = (e_1 - e_2) / 2. Doubling is its inverse, a step e_0 += e_1, e_1 += e_2, and e_2, e_3 by
//   linear extrapolation. A step is halved while max(|e_2|, |e_3|) > 6 E on an axis, and doubled, where it starts on
//   the coarser grid, while max(|e_3|, |2 e_2 - e_3|) <= 6 E / 4.
// Cost: halvings and doublings included.
// Bound: none for the tolerance: 6 E on each axis is a second derivative of up to 6 sqrt(d) E, and 8 E is the bound.
//   The error in the plane is at most 6 sqrt(2) / 8 = 1.0607 E.
// Fails: parts are halves, quarters, ...; roundings add up along the curve. The finest step is 2^-16.
#pragma once

#include <algorithm>

#include "core/flatten/flattening.hpp"

namespace bezierbench {

struct HybridDifferences {
  static constexpr MethodInfo info{.id = "hybrid_differences",
                                   .label = "Hybrid forward differencing",
                                   .problem = Problem::flattening,
                                   .min_degree = 3,
                                   .max_degree = 3,
                                   .promise = "1.0607 times the tolerance in the plane, apart from roundings",
                                   .flops = "6d",
                                   .citation = "[Goossen and Olynyk 1995]; [Lien et al. 1987]"};

  template <int Dimension, int Degree>
  static void flatten(const Curve<Form::bernstein, double, Dimension, Degree>& curve, double tolerance,
                      Flattening& chords) {
    using P = Point<double, Dimension>;
    const auto b = [&](int i) { return control_point(curve, i); };
    P e0 = b(0);
    P e1 = b(3) - b(0);
    P e2 = 6 * (b(1) - 2 * b(2) + b(3));
    P e3 = 6 * (b(0) - 2 * b(1) + b(2));
    const double limit = 6 * tolerance;
    const auto largest = [](const P& a, const P& c) {
      return std::max(a.template lpNorm<Eigen::Infinity>(), c.template lpNorm<Eigen::Infinity>());
    };
    constexpr int finest = max_chords;
    int width = finest;  // of a step, in units of the finest one
    chords.add(0, e0);
    for (int at = 0;;) {
      while (largest(e2, e3) > limit && width > 1) {
        e3 *= 0.25;
        e2 = 0.125 * e2 + 0.5 * e3;
        e1 = 0.5 * (e1 - e2);
        width /= 2;
        ++chords.evaluations;
      }
      chords.complete = chords.complete && largest(e2, e3) <= limit;
      while (at % (2 * width) == 0 && at + 2 * width <= finest && largest(e3, 2 * e2 - e3) <= 0.25 * limit) {
        e1 = 2 * e1 + e2;
        e2 = 8 * e2 - 4 * e3;
        e3 *= 4;
        width *= 2;
        ++chords.evaluations;
      }
      at += width;
      ++chords.evaluations;
      if (at >= finest) break;
      e0 += e1;
      const P last = e2;
      e1 += e2;
      e2 = 2 * e2 - e3;
      e3 = last;
      chords.add(static_cast<double>(at) / finest, e0);
    }
    chords.add(1, b(3));
  }
};

}  // namespace bezierbench
