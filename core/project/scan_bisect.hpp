// SPDX-License-Identifier: MIT
// Formula: the nearest of 26 samples, then bisection between its neighbours: the middle k moves towards the nearer of
//   k - e and k + e until the interval is no longer than e.
// Source: the document's first answer (closestPoint and localMinimum). Three things differ: k +- e stay in [0, 1], e is
//   2^-26, and k is polished. The answer's e of 1e-4 leaves an error of this size in t; with an e below about 1e-8 the
//   two distances agree in all digits, so that their comparison is decided by rounding.
// Bound: polished_residual_bound of (C - P).C' at t inside (0, 1).
// Fails: it finds one local minimum, that of the nearest sample. (8,5) (-4,0) (6,3) (9,7) and P = (6,4) give t = 0.7459
//   at the distance 0.3085, and the nearest point is at t = 0.064530, distance 0.141664.
#pragma once

#include "core/project/refine.hpp"
#include "core/project/scan.hpp"

namespace bezierbench {

struct ScanBisect {
  static constexpr MethodInfo info{.id = "scan_bisect",
                                   .label = "25 scans and bisection",
                                   .problem = Problem::projection,
                                   .form = Form::bernstein,
                                   .min_degree = 1,
                                   .flops = "70 points by de Casteljau",
                                   .cost_exponent = 2,
                                   .citation = "[Document 004]"};
  static constexpr auto residual_bound = polished_residual_bound;

  template <Form F, int Dimension>
  static FootPoint project(const Curve<F, double, Dimension>& curve, const Point<double, Dimension>& point) {
    constexpr int scans = 25;
    constexpr double e = 0x1p-26;
    const auto offset = offset_of(curve, point);
    const double best = nearest_sample(offset, 0.0, 1.0, scans);
    double from = std::max(best - 1.0 / scans, 0.0);
    double to = std::min(best + 1.0 / scans, 1.0);
    double k = best;
    int candidates = scans + 1;
    while (to - from > e) {
      k = (from + to) / 2;
      const double before = squared_distance(offset, std::max(k - e, 0.0));
      const double after = squared_distance(offset, std::min(k + e, 1.0));
      (before < after ? to : from) = k;
      candidates += 2;
    }
    const double t = polished(offset, k);
    return {t, offset.distance(t), candidates, true};
  }
};

}  // namespace bezierbench
