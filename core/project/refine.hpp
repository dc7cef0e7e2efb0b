// SPDX-License-Identifier: MIT
// Refines a rough estimate of a root of (C - P).C' to the last bits. Each step starts from the control points: the
// coefficients of (C - P).C' are rounded, and at a cusp this moves their roots by the cube root of u.
#pragma once

#include "core/project/offset_curve.hpp"

namespace bezierbench {

/// An estimate of a root. In an estimate from Newton's method `step` is its last step.
struct RootEstimate {
  double t;
  double step;  ///< the next step should be half as long or less
};

/// A root of (C - P).C' between a < b, where its signs differ, from an estimate in [a, b]: Newton steps, and bisection
/// where a step leaves the bracket or is more than half of the step before. Ends where a and b are neighbours, or after
/// a step s whose error bound 2 s^2 |f''| / |f'| is at most u t (Kantorovich's theorem; [Ortega and Rheinboldt 1970],
/// 12.6.2).
template <int Dimension, int Degree>
double root_in_bracket(const OffsetCurve<Dimension, Degree>& curve, double a, double b, bool rising,
                       const RootEstimate& estimate) {
  constexpr int most_steps = 200;  // every second step halves the bracket, of at most 2^53 doubles per binade
  auto [t, last_step] = estimate;
  for (int k = 0; k < most_steps; ++k) {
    const auto f = curve.slope(t);
    if (f.value == 0) break;
    ((f.value < 0) == rising ? a : b) = t;
    double next = t - f.value / f.derivative;
    double step = next - t;
    const bool inside = next >= a && next <= b;
    if (inside && 2 * step * step * curve.largest_bend() <= 0x1p-53 * next * std::abs(f.derivative)) return next;
    if (!inside || 2 * std::abs(step) > std::abs(last_step)) {
      next = a + (b - a) / 2;
      step = next - t;
    }
    if (next == a || next == b) break;
    t = next;
    last_step = step;
  }
  return t;
}

/// A parameter in [0, 1] at which the curve is at least as near as at t. Takes Newton steps where the distance is
/// convex, else Gauss-Newton steps. A step is halved until the curve comes nearer; the search ends when it does not.
template <int Dimension, int Degree>
double descend(const OffsetCurve<Dimension, Degree>& curve, double t) {
  constexpr int most_steps = 100;
  constexpr int most_halvings = 8;
  double distance = curve.scaled_distance(t);
  for (int k = 0; k < most_steps; ++k) {
    const auto f = curve.slope(t);
    const double steepness = f.derivative > 0 ? f.derivative : f.speed_squared;
    if (f.value == 0 || steepness == 0) return t;
    double step = -f.value / steepness;
    const double before = t;
    for (int halving = 0; halving <= most_halvings && t == before; ++halving, step /= 2) {
      const double next = std::clamp(before + step, 0.0, 1.0);
      const double next_distance = curve.scaled_distance(next);
      if (next_distance < distance) {
        t = next;
        distance = next_distance;
      }
    }
    if (t == before) return t;
  }
  return t;
}

}  // namespace bezierbench
