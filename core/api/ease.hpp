// SPDX-License-Identifier: MIT
// y for x on an easing curve, cubic-bezier(x1, y1, x2, y2) of CSS, in one call:
//
//   double y = bezierbench::ease({0.25, 0.1, 0.25, 1.0}, 0.5);
//   float z = bezierbench::ease<EasingHalley>({0.25F, 0.1F, 0.25F, 1.0F}, 0.5F);
//
// The methods are in core/easing. EasingCorrectlyRounded needs the compiled part of the package; the others are headers
// alone.
#pragma once

#include <cmath>
#include <concepts>
#include <stdexcept>
#include <type_traits>

#include "core/easing/roster.hpp"

namespace bezierbench {

/// An easing curve that is prepared once, for many x: `const EasingFunction<double> at({0.25, 0.1, 0.25, 1}); at(0.5)`.
template <std::floating_point Scalar, EasingMethod Method = EasingCorrectlyRounded>
requires EasesIn<Method, Scalar>
class EasingFunction {
 public:
  /// Throws std::invalid_argument unless x1 and x2 are in [0, 1] and y1 and y2 are finite.
  explicit EasingFunction(const EasingCurve<Scalar>& curve)
      : prepared_(Method::prepare(checked(curve))), slopes_(curve) {}

  /// y at x. Outside [0, 1] it is on the tangents of the curve's ends ([CSS Easing 2023], section 2.3). Throws
  /// std::invalid_argument for an x that is not finite.
  Scalar operator()(Scalar x) const {
    if (!std::isfinite(x)) throw std::invalid_argument("bezierbench: x must be finite");
    return ease<Method>(prepared_, slopes_, x).y;
  }

 private:
  static const EasingCurve<Scalar>& checked(const EasingCurve<Scalar>& curve) {
    if (!is_easing(curve))
      throw std::invalid_argument("bezierbench: x1 and x2 of an easing curve must be in [0, 1], y1 and y2 finite");
    return curve;
  }

  std::remove_cvref_t<decltype(Method::prepare(EasingCurve<Scalar>{}))> prepared_;
  EndSlopes<Scalar> slopes_;
};

/// y at x of one easing curve, by default the number nearest to the true y for x in [0, 1]. Throws as EasingFunction
/// does.
template <EasingMethod Method = EasingCorrectlyRounded>
double ease(const EasingCurve<double>& curve, double x) {
  return EasingFunction<double, Method>(curve)(x);
}
template <EasingMethod Method = EasingCorrectlyRounded>
float ease(const EasingCurve<float>& curve, float x) {
  return EasingFunction<float, Method>(curve)(x);
}

}  // namespace bezierbench
