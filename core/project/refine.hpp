// SPDX-License-Identifier: MIT
// Refines a rough estimate of a root of (C - P).C' to the last bits. Each step starts from the control points: the
// coefficients of (C - P).C' are rounded, and at a cusp this moves their roots by the cube root of u.
#pragma once

#include <limits>

#include "core/project/kernel.hpp"
#include "core/project/offset_curve.hpp"

namespace bezierbench {

/// An estimate of a root. In an estimate from Newton's method `step` is its last step.
struct RootEstimate {
  double t;
  double step;  ///< the next step should be at most half as long
};

/// A root of (C - P).C' between a < b, where its signs differ, from an estimate in [a, b]: Newton steps, and bisection
/// where a step leaves the bracket or is more than half of the step before. Ends where a and b are neighbours, or after
/// a step s whose error bound 2 s^2 |f''| / |f'| is at most u t (Kantorovich's theorem; [Ortega and Rheinboldt 1970],
/// 12.6.2).
template <class Offset>
double root_in_bracket(const Offset& curve, double a, double b, bool rising, const RootEstimate& estimate) {
  constexpr int max_steps = 200;  // every second step halves the bracket, of at most 2^53 doubles per binade
  auto [t, last_step] = estimate;
  for (int k = 0; k < max_steps; ++k) {
    const auto f = curve.slope(t);
    if (f.value == 0) break;
    ((f.value < 0) == rising ? a : b) = t;
    double next = t - f.value / f.derivative;
    double step = next - t;
    const bool inside = next >= a && next <= b;
    if (inside && 2 * step * step * curve.largest_bend() <= 0x1p-53 * next * std::abs(f.derivative)) return next;
    const double other_end = t == a ? b : a;
    if (!inside || next == other_end || 2 * std::abs(step) > std::abs(last_step)) {
      next = a + (b - a) / 2;
      step = next - t;
    }
    if (next == a || next == b) break;
    t = next;
    last_step = step;
  }
  return t;
}

/// The parameter in [0, 1] of the local minimum of the distance that lies downhill from t; t where the curve is farther
/// there. Distances next to a minimum differ in their last digits only, so a search by distances ends at half of the
/// digits of t; a root of (C - P).C' has them all. Signs bracket it: steps downhill double, from twice Newton's step
/// on.
template <class Offset>
double polished(const Offset& curve, double t) {
  constexpr double min_step = 0x1p-52;
  constexpr double rounding = 1 + 8 * 0x1p-53;  // of two distances
  const auto f = curve.slope(t);
  if (f.value == 0) return t;
  const bool falls_to_the_right = f.value < 0;
  const double end = falls_to_the_right ? 1 : 0;
  if (t == end) return t;
  const auto falls = [&](double value) { return falls_to_the_right ? value < 0 : value > 0; };
  const double newton = f.derivative > 0 ? std::abs(f.value) / f.derivative : 0;
  double near = t;
  double far = t;
  double at_far = f.value;
  for (double step = std::max(2 * newton, min_step); far != end && falls(at_far); step *= 2) {
    near = far;
    far = std::clamp(falls_to_the_right ? t + step : t - step, 0.0, 1.0);
    at_far = curve.slope(far).value;
  }
  double minimum = far;
  if (falls(-at_far)) {
    const auto [a, b] = std::minmax(near, far);
    minimum = root_in_bracket(curve, a, b, true, {a + (b - a) / 2, b - a});
  }
  return curve.scaled_distance(minimum) <= curve.scaled_distance(t) * rounding ? minimum : t;
}

/// The bound of the residual |(C - P).C'| at a polished t inside (0, 1), over u D (|C - P| + D t + 2 n u M), with
/// D = n max |b_(i+1) - b_i| and M the largest coordinate. The computed (C - P).C' is off by d (3n + 6) of these units
/// (OffsetCurve). It changes its sign between t and a double at most two from it, over which the true one changes by
/// 4 u t (D^2 + |C - P| max |C''|), with |C''| <= 2 (n - 1) D.
constexpr double polished_residual_bound(int n, int dimension) { return dimension * (3 * n + 6) + 8 * n; }

// The nearest of several parameters: the last step of every projector that finds candidates first.

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
