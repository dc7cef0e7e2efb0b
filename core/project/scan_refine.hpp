// SPDX-License-Identifier: MIT
// Formula: repeated slicing: the nearest of 17 samples, then of 17 samples between its neighbours, and so on until the
//   interval is shorter than 2^-52.
// Source: the document's second answer, whose recursive form leaves both numbers to the caller. Two things differ:
//   samples are multiples of a slice, not sums of it, so that the last is the end of the interval; and t is polished,
//   since distances that are compared squared leave it half of its digits.
// Bound: polished_residual_bound of (C - P).C' at t inside (0, 1).
// Fails: it finds one local minimum, as scan_bisect.
#pragma once

#include "core/project/refine.hpp"
#include "core/project/scan.hpp"

namespace bezierbench {

struct ScanRefine {
  static constexpr MethodInfo info{.id = "scan_refine",
                                   .label = "Repeated slicing",
                                   .problem = Problem::projection,
                                   .form = Form::bernstein,
                                   .min_degree = 1,
                                   .flops = "323 points by de Casteljau",
                                   .cost_exponent = 2,
                                   .citation = "[Document 004]"};
  static constexpr auto residual_bound = polished_residual_bound;

  template <Form F, int Dimension>
  static FootPoint project(const Curve<F, double, Dimension>& curve, const Point<double, Dimension>& point) {
    constexpr int slices = 16;
    const auto offset = offset_of(curve, point);
    double from = 0;
    double to = 1;
    double best = 0;
    int candidates = 0;
    do {
      best = nearest_sample(offset, from, to, slices);
      const double slice = (to - from) / slices;
      from = std::max(best - slice, 0.0);
      to = std::min(best + slice, 1.0);
      candidates += slices + 1;
    } while (to - from >= 0x1p-52);
    const double t = polished(offset, best);
    return {t, offset.distance(t), candidates, true};
  }
};

}  // namespace bezierbench
