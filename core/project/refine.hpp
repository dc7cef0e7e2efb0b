// SPDX-License-Identifier: MIT
// From a root that is known roughly to one that is known to the last bits, always from the control points: the
// coefficients of (C - P).C' were rounded, and at a cusp their roots are off by the cube root of that.
#pragma once

#include "core/project/offset_curve.hpp"

namespace bezierbench {

/// A root of (C - P).C' between a < b, where its signs differ: Newton steps, bisection where a step leaves the bracket
/// or the steps do not halve. Ends when t does not move any more.
template <int Dimension>
double root_in_bracket(const OffsetCurve<Dimension>& curve, double a, double b, bool rising) {
  constexpr int most_steps = 200;  // each second one halves a bracket that has at most 2^53 doubles a binade
  double t = a + (b - a) / 2;
  double step = b - a;
  for (int k = 0; k < most_steps; ++k) {
    const auto f = curve.slope(t);
    if (f.value == 0) break;
    ((f.value < 0) == rising ? a : b) = t;
    double next = t - f.value / f.derivative;
    if (!(next > a && next < b && 2 * std::abs(next - t) <= std::abs(step))) next = a + (b - a) / 2;
    step = next - t;
    if (next == t || next == a || next == b) break;
    t = next;
  }
  return t;
}

/// A parameter in [0, 1] at least as near as t: Newton steps where the distance curves upwards, else those of Gauss and
/// Newton, each halved until it brings the curve nearer. Ends when none does.
template <int Dimension>
double descend(const OffsetCurve<Dimension>& curve, double t) {
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

/// t in [0, 1], or the double beside it that is nearer by more than rounding: Newton's last step may end one off, and
/// next to the curve an ulp of t is several of the distance.
template <int Dimension>
double nearest_neighbour(const OffsetCurve<Dimension>& curve, double t) {
  double best = t;
  for (const double other : {std::nextafter(t, 0.0), std::nextafter(t, 1.0)})
    if (curve.scaled_distance(other) < curve.scaled_distance(best) * (1 - 0x1p-50)) best = other;
  return best;
}

}  // namespace bezierbench
