// SPDX-License-Identifier: MIT
// Formula: the nearest of 26 samples, then bisection between its neighbours, as the code of [Document 004] has it: the
//   middle k moves towards the nearer of k - e and k + e, e = 1e-4, until the interval is no longer than e. The last k
//   is the answer.
// Source: the document's closestPoint and localMinimum, a baseline for scan_bisect. Samples are tried from t = 1 down,
//   so that of equally near ones the last is taken. k - e and k + e may leave [0, 1].
// Bound: none. k is off by up to about 1e-4 from the local minimum, also from one at an end.
// Fails: as scan_bisect it finds one local minimum. On the curve the distance is not 0 but of the order of 1e-4 of the
//   speed. A smaller e does not help: with e below about 1e-8 both distances agree in all digits.
#pragma once

#include "core/project/kernel.hpp"
#include "core/project/scan.hpp"

namespace bezierbench {

struct Seed004Scan {
  static constexpr MethodInfo info{.id = "seed_004_scan",
                                   .label = "25 scans and bisection, as printed",
                                   .problem = Problem::projection,
                                   .form = Form::bernstein,
                                   .min_degree = 1,
                                   .flops = "46 points by de Casteljau",
                                   .cost_exponent = 2,
                                   .citation = "[Document 004], first answer"};

  template <int Dimension>
  static FootPoint project(const Curve<Form::bernstein, double, Dimension>& curve,
                           const Point<double, Dimension>& point) {
    constexpr int scans = 25;
    constexpr double e = 1e-4;
    const OffsetCurve<Dimension> offset(curve, point);
    int nearest = 0;
    double least = std::numeric_limits<double>::infinity();
    for (int i = scans; i >= 0; --i)
      if (const double squared = squared_distance(offset, static_cast<double>(i) / scans); squared < least) {
        least = squared;
        nearest = i;
      }
    double from = std::max((nearest - 1.0) / scans, 0.0);
    double to = std::min((nearest + 1.0) / scans, 1.0);
    double k = from;
    int candidates = scans + 1;
    while (to - from > e) {
      k = (to + from) / 2;
      (squared_distance(offset, k - e) < squared_distance(offset, k + e) ? to : from) = k;
      candidates += 2;
    }
    return {k, offset.distance(k), candidates, true};
  }
};

}  // namespace bezierbench
