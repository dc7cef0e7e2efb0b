// SPDX-License-Identifier: MIT
// Formula: t^3 + 3 p t^2 + 3 q t + r = 0 with t = w - p becomes w^3 + 3 h w + 2 g = 0, h = q - p^2 and g = p^3 - 3 p q
//   / 2 + r / 2. For g^2 + h^3 > 0 the root is v - h/v, v = cbrt(-g -+ sqrt(g^2 + h^3)) with the sign that does not
//   cancel; else there are three, 2 sqrt(-h) cos((phi + 2 pi k) / 3), cos phi = -g / sqrt(-h^3), and the one in [0, 1]
//   is taken. Where the leading coefficient vanishes it is a quadratic or a line.
// Bound: none. By p and q, errors grow with the inverse of the leading coefficient.
// Fails: near-quadratic x(t), whose leading coefficient is small, leaves few digits; near double roots half are lost.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "core/easing/easing.hpp"

namespace bezierbench {

struct EasingCardano {
  static constexpr MethodInfo info{.id = "easing_cardano",
                                   .label = "Cardano's formula",
                                   .problem = Problem::easing,
                                   .min_degree = 3,
                                   .max_degree = 3,
                                   .bit_stable = false,
                                   .flops = "40 and a cube root, or an arc cosine and three cosines",
                                   .citation = "[Press et al. 2007], section 5.6"};

  template <class Scalar>
  static UnitCubics<Scalar> prepare(const EasingCurve<Scalar>& curve) {
    return UnitCubics<Scalar>(curve);
  }

  template <class Scalar>
  static Eased<Scalar> solve(const UnitCubics<Scalar>& curve, Scalar x) {
    const Scalar t = std::clamp(root(curve.x.a, curve.x.b, curve.x.c, x), Scalar(0), Scalar(1));
    return {t, curve.y.at(t)};
  }

 private:
  /// The root of a t^3 + b t^2 + c t = x that is in [0, 1] up to rounding.
  template <class Scalar>
  static Scalar root(Scalar a, Scalar b, Scalar c, Scalar x) {
    constexpr Scalar vanishes = 4 * std::numeric_limits<Scalar>::epsilon();
    if (std::abs(a) <= vanishes) {
      if (std::abs(b) <= vanishes) return x / c;
      // 2 x / (c + sqrt(...)): c >= 0, so that nothing cancels, and the root is the one that goes to 0 with x
      return 2 * x / (c + std::sqrt(std::max(c * c + 4 * b * x, Scalar(0))));
    }
    const Scalar p = b / (3 * a);
    const Scalar q = c / (3 * a);
    const Scalar h = q - p * p;
    const Scalar g = p * p * p - (3 * p * q + x / a) / 2;
    const Scalar discriminant = g * g + h * h * h;
    if (discriminant > 0) {
      const Scalar v = std::cbrt(-g - std::copysign(std::sqrt(discriminant), g));
      return v - h / v - p;
    }
    const Scalar size = std::sqrt(-h);
    if (size == 0) return -p;
    const Scalar phi = std::acos(std::clamp(-g / (size * size * size), Scalar(-1), Scalar(1)));
    const auto outside = [](Scalar t) { return std::max(-t, t - 1); };
    Scalar best = 2 * size * std::cos(phi / 3) - p;
    for (const int k : {1, 2}) {
      const Scalar other = 2 * size * std::cos((phi + Scalar(2 * k) * std::numbers::pi_v<Scalar>) / 3) - p;
      if (outside(other) < outside(best)) best = other;
    }
    return best;
  }
};

}  // namespace bezierbench
