// SPDX-License-Identifier: MIT
// Formula: with Wang's count m, the differences d_s = D^s p of the points at 0, 1/m, ..., n/m; then d_s += d_(s+1) for
//   s = 0..n-1 is a step, and d_0 the next point.
// Bound: Wang's, and the roundings of the steps, which grow with m^n: core/grid/forward_differencing.hpp.
// Fails: as Wang's count; at high degrees and counts the roundings are visible beside the tolerance.
#pragma once

#include <array>

#include "core/flatten/wang_count.hpp"

namespace bezierbench {

struct ForwardDifferences {
  static constexpr int highest_degree = 10;
  static constexpr MethodInfo info{.id = "forward_differences",
                                   .label = "Forward differences by Wang's count",
                                   .problem = Problem::flattening,
                                   .min_degree = 1,
                                   .max_degree = highest_degree,
                                   .promise = "the tolerance, apart from roundings that grow with the count",
                                   .flops = "dn",
                                   .citation = "[Foley et al. 1990], section 11.2.9; [Sederberg 2012], section 10.6"};

  template <int Dimension, int Degree>
  static void flatten(const Curve<Form::bernstein, double, Dimension, Degree>& curve, double tolerance,
                      Flattening& chords) {
    const double wanted = wang_count(curve, tolerance);
    chords.complete = wanted <= max_chords;
    const int count = chords.complete ? static_cast<int>(wanted) : max_chords;
    const int n = curve.degree();
    const double step = 1.0 / count;
    const auto prepared = HornerBernstein::prepare(curve);
    std::array<Point<double, Dimension>, highest_degree + 1> d;
    for (int k = 0; k <= n; ++k)
      d[static_cast<std::size_t>(k)] =
          k <= count ? HornerBernstein::evaluate(prepared, k * step) : control_point(curve, n);
    for (int s = 1; s <= n; ++s)
      for (int k = n; k >= s; --k) d[static_cast<std::size_t>(k)] -= d[static_cast<std::size_t>(k) - 1];
    chords.add(0, control_point(curve, 0));
    for (int k = 1; k < count; ++k) {
      for (int s = 0; s < n; ++s) d[static_cast<std::size_t>(s)] += d[static_cast<std::size_t>(s) + 1];
      chords.add(k * step, d[0]);
    }
    chords.add(1, control_point(curve, n));
    chords.evaluations = n + 1;
  }
};

}  // namespace bezierbench
