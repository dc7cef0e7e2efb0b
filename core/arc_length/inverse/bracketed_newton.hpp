// SPDX-License-Identifier: MIT
// t <- t - (s(t) - S) / |C'(t)| inside an interval that holds the root, bisected where a step fails.
//
// Source: Newton's method for s(t) = S, from t = S / s(1); guarded as in Press, Teukolsky, Vetterling and Flannery,
//   Numerical Recipes, 3rd ed., section 9.4.
// Cost: per iteration a length of a part (inverse/part_length.hpp) and one speed.
// Estimate: |s(t) - S|, with what the quadratures and the roundings may be off.
// Converges: quadratically where |C'| > 0; at a cusp, where s(t) - S is like (t - c)|t - c|, the distance falls by 4 in
//   each step.
// Fails: not at all within the tolerances that double precision permits; below these it ends and says so.
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
                                   .citation = "Press et al. 2007, section 9.4"};

  template <int Dimension>
  static InverseArcLength solve(const Curve<Form::bernstein, double, Dimension>& hodograph, double target,
                                double tolerance) {
    Speed<Dimension> speed(hodograph);
    auto result = BracketedSearch<Dimension>(hodograph, target, tolerance).run([&](double t, double distance) {
      return t - distance / speed(t);
    });
    result.evaluations += speed.evaluations();
    return result;
  }
};

}  // namespace bezierbench
