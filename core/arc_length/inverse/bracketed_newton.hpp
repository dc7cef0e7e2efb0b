// SPDX-License-Identifier: MIT
// Formula: t <- t - (s(t) - S) / |C'(t)| from t = S / s(1), inside an interval that holds the root, bisected where a
//   step fails.
// Bound: |s(t) - S|, with the errors of the quadratures and the roundings added.
// Converges: quadratically where |C'| > 0. At a cusp, where s(t) - S is like (t - c)|t - c|, the distance falls by 4 in
//   each step.
// Fails: only for tolerances below those that double precision permits; then `converged` is false.
#pragma once

#include "core/arc_length/inverse/bracket.hpp"
#include "core/arc_length/speed.hpp"

namespace bezierbench {

struct BracketedNewton {
  static constexpr MethodInfo info{.id = "bracketed_newton",
                                   .label = "Newton in a bracket",
                                   .problem = Problem::inverse_arc_length,
                                   .form = Form::bernstein,
                                   .promise = "the tolerance, or converged is no",
                                   .flops = "per iteration a length and a speed",
                                   .cost_exponent = 2,
                                   .citation = "[Press et al. 2007], section 9.4"};

  template <class Hodograph>
  static InverseArcLength solve(const Hodograph& hodograph, double target, double tolerance) {
    auto speed = speed_of(hodograph);
    auto result = BracketedSearch(hodograph, target, tolerance).run([&](double t, double distance) {
      return t - distance / speed(t);
    });
    result.evaluations += speed.evaluations();
    return result;
  }
};

}  // namespace bezierbench
