// SPDX-License-Identifier: MIT
// What a method for point projection is: data about itself, and one function from a curve and a point to the parameter
// in [0, 1] at which the curve is nearest.
#pragma once

#include <concepts>

#include "core/curve.hpp"
#include "core/method.hpp"

namespace bezierbench {

/// Where a method says the curve is nearest to the point.
struct FootPoint {
  double t = 0;
  double distance = 0;    ///< |C(t) - P|, in coordinate units
  int candidates = 0;     ///< parameters or pieces whose distances were compared
  bool converged = true;  ///< false where the method gave up before it reached what it aims at
};

template <class M>
concept ProjectionMethod = requires(const Curve<Form::bernstein, double, 2>& curve, const Point<double, 2>& point) {
  requires M::info.problem == Problem::projection;
  { M::project(curve, point) } -> std::same_as<FootPoint>;
};

}  // namespace bezierbench
