// SPDX-License-Identifier: MIT
// Formula: the nearest of 33 points at equal steps of the arc length, then steps to the left or right that bring it
//   nearer, halved where neither does, until a step is below 2^-26 of the length.
// Source: the answer names this search on the paths of SVG; the steps of [Bostock 2013] are 8 pixels, then down to half
//   of one. Two things differ: steps are parts of the length, and t is polished. Lengths are those of 256 chords at
//   equal steps of t, and linear between these, as browsers approximate them.
// Bound: polished_residual_bound of (C - P).C' at t inside (0, 1).
// Fails: it finds one local minimum, as scan_bisect, though its samples do not crowd where the curve is slow.
#pragma once

#include <limits>
#include <vector>

#include "core/project/kernel.hpp"
#include "core/project/refine.hpp"
#include "core/project/scan.hpp"

namespace bezierbench {

struct ScanLength {
  static constexpr int chords = 256;
  static constexpr int scans = 32;

  static constexpr MethodInfo info{.id = "scan_length",
                                   .label = "Scan of the arc length",
                                   .problem = Problem::projection,
                                   .form = Form::bernstein,
                                   .min_degree = 1,
                                   .flops = "350 points by de Casteljau",
                                   .cost_exponent = 2,
                                   .citation = "[Document 004], last answer; [Bostock 2013]"};
  static constexpr auto residual_bound = polished_residual_bound;

  template <int Dimension>
  static FootPoint project(const Curve<Form::bernstein, double, Dimension>& curve,
                           const Point<double, Dimension>& point) {
    const OffsetCurve<Dimension> offset(curve, point);
    const auto lengths = lengths_along(offset);
    const double whole = lengths.back();
    int candidates = 0;
    double best = 0;
    double least = std::numeric_limits<double>::infinity();
    const auto nearer = [&](double length) {
      if (length < 0 || length > whole) return false;
      ++candidates;
      const double squared = squared_distance(offset, parameter(lengths, length));
      if (!(squared < least)) return false;
      least = squared;
      best = length;
      return true;
    };
    for (int i = 0; i <= scans; ++i) nearer(whole * i / scans);
    for (double step = whole / (2 * scans); step > whole * 0x1p-26;)
      if (!nearer(best - step) && !nearer(best + step)) step /= 2;
    const double t = polished(offset, parameter(lengths, best));
    return {t, offset.distance(t), candidates, true};
  }

 private:
  /// The sums of the chords up to t = k / chords, over m as in OffsetCurve.
  template <int Dimension>
  static std::vector<double> lengths_along(const OffsetCurve<Dimension>& offset) {
    std::vector<double> lengths{0};
    Point<double, Dimension> before = offset.offsets().col(0);
    for (int k = 1; k <= chords; ++k) {
      const auto here = point_at<Dimension>(offset.offsets(), static_cast<double>(k) / chords);
      lengths.push_back(lengths.back() + length<Dimension>(here - before));
      before = here;
    }
    return lengths;
  }

  /// The t at this length, which is at most that of the curve.
  static double parameter(const std::vector<double>& lengths, double length) {
    const auto after = std::upper_bound(lengths.begin() + 1, lengths.end() - 1, length);
    const double before = *(after - 1);
    const double share = *after > before ? std::min((length - before) / (*after - before), 1.0) : 0;
    return (static_cast<double>(after - 1 - lengths.begin()) + share) / chords;
  }
};

}  // namespace bezierbench
