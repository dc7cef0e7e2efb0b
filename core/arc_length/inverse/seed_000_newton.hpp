// SPDX-License-Identifier: MIT
// Formula: t <- t - d |C'| / (d |C''| + |C'|^2), d = s(t) - S: Newton's iteration for the minimum of d^2, as the code
//   of [Document 000] has it.
// Source: the document's code below eq. (20). With g = d^2 it takes g'/2 and, for g''/2, |C''| where the acceleration
//   along the curve C'.C''/|C'| belongs. The formulas above it, eq. (19), (20), also lack a factor 2, and taken as
//   printed they do not converge. Lengths are measured here by adaptive Gauss-Legendre rules, so that the iteration
//   alone is judged. The document's start is t = S / s(1). Its limits of iterations and of |d|, which it leaves open,
//   are 50 and the tolerance.
// Bound: |s(t) - S|, with the errors of the quadratures and the roundings added.
// Fails: nothing keeps t in [0, 1]; for d < 0 the denominator can vanish, and t jumps away. It gives up where t is
//   not finite or farther out than 1024.
#pragma once

#include <cmath>

#include "core/arc_length/inverse/inverse_arc_length.hpp"
#include "core/derivative/hodograph.hpp"
#include "core/evaluate/methods/horner_bernstein.hpp"

namespace bezierbench {

struct Seed000Newton {
  static constexpr int iteration_limit = 50;
  static constexpr double farthest = 1024;

  static constexpr MethodInfo info{.id = "seed_000_newton",
                                   .label = "Newton on the squared distance, as in Document 000",
                                   .problem = Problem::inverse_arc_length,
                                   .form = Form::bernstein,
                                   .promise = "the tolerance, or converged is no",
                                   .flops = "per iteration a length, a speed and a second derivative",
                                   .cost_exponent = 2,
                                   .citation = "[Document 000], section 3.3"};

  template <int Dimension>
  static InverseArcLength solve(const Curve<Form::bernstein, double, Dimension>& hodograph, double target,
                                double tolerance) {
    PartLength part(hodograph, tolerance);
    const auto velocity = HornerBernstein::prepare(hodograph);
    const auto acceleration = HornerBernstein::prepare(bezierbench::hodograph(hodograph, 1));
    const auto& whole = part.whole();
    InverseArcLength result{.t = target / whole.length};
    std::int64_t evaluations = 0;
    while (std::abs(result.t) <= farthest) {  // false for NaN
      const auto reached = part(0, result.t);
      const double distance = reached.length - target;
      result.error_estimate = std::abs(distance) + reached.error_estimate;
      const bool on_curve = result.t >= 0 && result.t <= 1;
      result.converged = on_curve && result.error_estimate <= tolerance * (whole.length - whole.error_estimate);
      if (result.converged || result.iterations == iteration_limit) break;
      ++result.iterations;
      evaluations += 2;
      const double speed = HornerBernstein::evaluate(velocity, result.t).norm();
      const double bend = HornerBernstein::evaluate(acceleration, result.t).norm();
      result.t -= distance * speed / (distance * bend + speed * speed);
    }
    result.evaluations = part.evaluations() + evaluations;
    return result;
  }
};

}  // namespace bezierbench
