// SPDX-License-Identifier: MIT
// One coordinate of an easing curve, and both: in power form, as browsers evaluate it, and in Bernstein form.
#pragma once

#include "core/easing/easing.hpp"

namespace bezierbench {

/// 3 p1 t (1-t)^2 + 3 p2 t^2 (1-t) + t^3 as ((a t + b) t + c) t: loses digits where the terms cancel.
template <class Scalar>
struct UnitCubic {
  UnitCubic(Scalar p1, Scalar p2) : c(3 * p1), b(3 * (p2 - p1) - c), a(1 - c - b) {}
  [[nodiscard]] Scalar at(Scalar t) const { return ((a * t + b) * t + c) * t; }
  [[nodiscard]] Scalar slope(Scalar t) const { return (3 * a * t + 2 * b) * t + c; }

  Scalar c, b, a;
};

template <class Scalar>
struct UnitCubics {
  explicit UnitCubics(const EasingCurve<Scalar>& curve) : x(curve.x1, curve.x2), y(curve.y1, curve.y2) {}
  UnitCubic<Scalar> x, y;
};

/// The same sum in Bernstein form. With p1 and p2 in [0, 1] no terms cancel: its relative error is a few u.
template <class Scalar>
Scalar bernstein_cubic(Scalar p1, Scalar p2, Scalar t) {
  const Scalar s = 1 - t;
  return t * (3 * s * (s * p1 + t * p2) + t * t);
}

/// Its derivative.
template <class Scalar>
Scalar bernstein_cubic_slope(Scalar p1, Scalar p2, Scalar t) {
  const Scalar s = 1 - t;
  return 3 * (s * s * p1 + 2 * s * t * (p2 - p1) + t * t * (1 - p2));
}

}  // namespace bezierbench
