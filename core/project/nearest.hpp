// SPDX-License-Identifier: MIT
// The nearest of several parameters: the last step of every projector that finds candidates first.
#pragma once

#include <limits>

#include "core/project/offset_curve.hpp"
#include "core/project/projection.hpp"

namespace bezierbench {

template <int Dimension>
struct NearestCandidate {
  double t;
  Point<double, Dimension> offset;  ///< (C(t) - P) / m, as in OffsetCurve
  double scaled_distance;           ///< its length
  int candidates;                   ///< number of distinct candidates

  /// Moves to another parameter if its distance is below `share` of the present one.
  template <int Degree>
  void take(const OffsetCurve<Dimension, Degree>& curve, double other, double share) {
    const auto its_offset = curve.at(other);
    const double distance = length<Dimension>(its_offset);
    if (!(distance < scaled_distance * share)) return;
    t = other;
    offset = its_offset;
    scaled_distance = distance;
  }
};

/// The nearest of these parameters in [0, 1] and both ends of the curve. Of equally near ones it is the smallest
/// parameter. A parameter that occurs twice counts once.
template <int Dimension, int Degree, class Candidates>
NearestCandidate<Dimension> nearest_candidate(const OffsetCurve<Dimension, Degree>& curve, Candidates candidates) {
  candidates.push_back(1);
  if (!std::is_sorted(candidates.begin(), candidates.end())) std::sort(candidates.begin(), candidates.end());
  NearestCandidate<Dimension> best{0, curve.offsets().col(0), curve.scaled_distance(0), 1};
  double before = 0;
  for (const double t : candidates) {
    if (t == before) continue;
    before = t;
    ++best.candidates;
    best.take(curve, t, 1);
  }
  return best;
}

/// The candidate or, if one is nearer by more than rounding, 8 u, the nearer of its neighbouring doubles. Newton's last
/// step may be off by one double, and next to the curve an ulp of t is several ulps of the distance.
///
/// Elsewhere the neighbours need no evaluation. They are at most u away in t. A computed distance is off by at most
/// 3.5 u of itself and the error of the compensated triangle. Where the square of the distance falls by at most u of
/// itself, these leave no room for 8 u.
template <int Dimension, int Degree>
NearestCandidate<Dimension> nearest_neighbour(const OffsetCurve<Dimension, Degree>& curve,
                                              const NearestCandidate<Dimension>& candidate) {
  constexpr double u = 0x1p-53;
  auto best = candidate;
  if (curve.largest_fall(best.t, best.offset, best.scaled_distance, u) <=
      u * best.scaled_distance * best.scaled_distance)
    return best;
  for (const double other : {std::nextafter(candidate.t, 0.0), std::nextafter(candidate.t, 1.0)})
    best.take(curve, other, 1 - 8 * u);
  return best;
}

}  // namespace bezierbench
