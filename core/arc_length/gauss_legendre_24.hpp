// SPDX-License-Identifier: MIT
// Formula: the Gauss-Legendre rule with 24 points on the whole curve, as libraries for Bezier curves often use it.
// Bound: none, and no estimate, whatever the tolerance; so `converged` is always false.
// Fails: at and near cusps, without indicating it.
#pragma once

#include "core/arc_length/arc_length.hpp"
#include "core/arc_length/gauss_legendre.hpp"
#include "core/arc_length/speed.hpp"

namespace bezierbench {

struct GaussLegendre24 {
  static constexpr MethodInfo info{.id = "gauss_legendre_24",
                                   .label = "Gauss-Legendre, 24 points",
                                   .problem = Problem::arc_length,
                                   .form = Form::bernstein,
                                   .promise = "none: converged is no",
                                   .flops = "24 speeds of (n-1)(1+3d) + 2d + 2",
                                   .citation = "[Davis and Rabinowitz 1984], section 2.7"};

  template <class Hodograph>
  static ArcLength measure(const Hodograph& hodograph, double /*tolerance*/) {
    auto speed = speed_of(hodograph);
    ArcLength result;
    result.length = gauss_integral<24>(speed);
    result.evaluations = speed.evaluations();
    return result;
  }
};

}  // namespace bezierbench
