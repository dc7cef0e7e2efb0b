// SPDX-License-Identifier: MIT
// The concept of a method for point projection: `info`, and one function from a curve and a point to the parameter in
// [0, 1] where the curve is nearest to the point.
#pragma once

#include <concepts>

#include "core/curve.hpp"
#include "core/method.hpp"
#include "core/project/kernel.hpp"

namespace bezierbench {

template <class M>
concept ProjectionMethod = requires(const Curve<M::info.form, double, 2>& curve, const Point<double, 2>& point) {
  requires M::info.problem == Problem::projection;
  { M::project(curve, point) } -> std::same_as<FootPoint>;
};

}  // namespace bezierbench
