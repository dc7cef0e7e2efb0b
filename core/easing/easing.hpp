// SPDX-License-Identifier: MIT
// The concept of a method for easing: y for a given x of the curve (0,0) (x1,y1) (x2,y2) (1,1), x1 and x2 in [0, 1],
// which is cubic-bezier(x1, y1, x2, y2) of CSS. Methods solve x(t) = x for x in [0, 1]; beyond the ends the curve goes
// on as a straight line, the same for all methods.
#pragma once

#include <cmath>
#include <concepts>

#include "core/method.hpp"

namespace bezierbench {

template <class Scalar>
struct EasingCurve {
  Scalar x1, y1, x2, y2;
};

/// True for curves of which x(t) does not fall: x1 and x2 in [0, 1]; y1 and y2 are any finite numbers.
template <class Scalar>
bool is_easing(const EasingCurve<Scalar>& c) {
  return c.x1 >= 0 && c.x1 <= 1 && c.x2 >= 0 && c.x2 <= 1 && std::isfinite(c.y1) && std::isfinite(c.y2);
}

/// The answer at one x.
template <class Scalar>
struct Eased {
  Scalar t = 0;  ///< where the method took y; an end of [0, 1] for x outside
  Scalar y = 0;
  int steps = 0;          ///< steps of all loops that it ran to find t
  bool converged = true;  ///< false where a loop was ended by most_easing_steps
};

/// No loop takes more steps: published ones that would not end are ended here.
inline constexpr int most_easing_steps = 1000;

/// Of a method that solves the curve as it is given.
struct EasingAsGiven {
  template <class Scalar>
  static const EasingCurve<Scalar>& prepare(const EasingCurve<Scalar>& curve) {
    return curve;
  }
};

/// `solve(prepared, x)` takes x in [0, 1] and neither allocates, prints nor throws; correctly_rounded alone may
/// allocate.
template <class M, class Scalar>
concept EasesIn = requires(const EasingCurve<Scalar>& curve, Scalar x) {
  { M::solve(M::prepare(curve), x) } -> std::same_as<Eased<Scalar>>;
};
template <class M>
concept EasingMethod = M::info.problem == Problem::easing&& EasesIn<M, float>&& EasesIn<M, double>;

/// The slopes of the lines before x = 0 and after x = 1: those of the tangents, which at an end that coincides with its
/// control point pass through the next one; 1 where all points of that side coincide; 0 for vertical ones. Source:
/// [CSS Easing 2023], section 2.3, with csswg-drafts#4046, as browsers have it.
template <class Scalar>
struct EndSlopes {
  explicit EndSlopes(const EasingCurve<Scalar>& c)
      : start(slope(c.x1, c.y1, c.x2, c.y2)), end(slope(1 - c.x2, 1 - c.y2, 1 - c.x1, 1 - c.y1)) {}
  Scalar start;
  Scalar end;

 private:
  static Scalar slope(Scalar near_x, Scalar near_y, Scalar far_x, Scalar far_y) {
    if (near_x > 0) return near_y / near_x;
    if (near_y != 0) return 0;
    if (far_x > 0) return far_y / far_x;
    return far_y == 0 ? Scalar(1) : Scalar(0);
  }
};

/// The answer at any x that is not NaN. Outside [0, 1] it has the roundings of two differences, their quotient, a
/// product and a sum: 4 u of the step from the end, and u |y|.
template <EasingMethod M, class Scalar, class Prepared>
Eased<Scalar> ease(const Prepared& prepared, const EndSlopes<Scalar>& slopes, Scalar x) {
  if (x < 0) return {0, slopes.start * x};
  if (x > 1) return {1, 1 + slopes.end * (x - 1)};
  return M::solve(prepared, x);
}

// One coordinate of an easing curve, and both: in power form, as browsers evaluate it, and in Bernstein form.

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
