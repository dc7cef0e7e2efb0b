// SPDX-License-Identifier: MIT
// The nearest of several parameters: the last step of every projector that finds candidates first.
#pragma once

#include <limits>
#include <vector>

#include "core/project/offset_curve.hpp"
#include "core/project/projection.hpp"

namespace bezierbench {

struct NearestCandidate {
  double t;
  double scaled_distance;  ///< the distance over m, as in OffsetCurve
  int candidates;          ///< number of distinct candidates
};

/// The nearest of these parameters in [0, 1] and both ends of the curve. Of equally near ones it is the smallest
/// parameter. A parameter that occurs twice counts once.
template <int Dimension, int Degree, class Candidates>
NearestCandidate nearest_candidate(const OffsetCurve<Dimension, Degree>& curve, Candidates candidates) {
  candidates.insert(candidates.end(), {0.0, 1.0});
  std::sort(candidates.begin(), candidates.end());
  candidates.erase(std::unique(candidates.begin(), candidates.end()), candidates.end());
  NearestCandidate best{0, std::numeric_limits<double>::infinity(), static_cast<int>(candidates.size())};
  for (const double t : candidates)
    if (const double distance = curve.scaled_distance(t); distance < best.scaled_distance) {
      best.t = t;
      best.scaled_distance = distance;
    }
  return best;
}

/// The candidate or, if one is nearer by more than rounding, the nearer of its neighbouring doubles. Newton's last step
/// may be off by one double, and next to the curve an ulp of t is several ulps of the distance.
template <int Dimension, int Degree>
NearestCandidate nearest_neighbour(const OffsetCurve<Dimension, Degree>& curve, const NearestCandidate& candidate) {
  auto best = candidate;
  for (const double other : {std::nextafter(candidate.t, 0.0), std::nextafter(candidate.t, 1.0)})
    if (const double distance = curve.scaled_distance(other); distance < best.scaled_distance * (1 - 0x1p-50)) {
      best.t = other;
      best.scaled_distance = distance;
    }
  return best;
}

/// The nearest of the candidates and both ends, as the result of a method.
template <int Dimension>
FootPoint nearest(const OffsetCurve<Dimension>& curve, std::vector<double> candidates) {
  const auto best = nearest_candidate(curve, std::move(candidates));
  return {best.t, curve.unscaled(best.scaled_distance), best.candidates, true};
}

}  // namespace bezierbench
