// SPDX-License-Identifier: MIT
// Formula: t <- t - 2 d s' / (2 s'^2 - d s''), d = s(t) - S, s' = |C'|, s'' = C'.C'' / |C'|, in the bracket of
//   bracketed_newton.
// Source: [Traub 1964], section 5.2, Halley's method. Safeguarded: a step out of the interval, or one after which the
//   distance was not halved, is a bisection.
// Cost: per iteration a length of a part, one speed and one second derivative.
// Bound: as bracketed_newton.
// Converges: cubically where |C'| > 0. As each length costs far more than a derivative, an iteration saved pays.
// Fails: as bracketed_newton.
#pragma once

#include "core/arc_length/inverse/bracket.hpp"
#include "core/derivative/hodograph.hpp"
#include "core/evaluate/methods/horner_bernstein.hpp"

namespace bezierbench {

struct Halley {
  static constexpr MethodInfo info{.id = "halley",
                                   .label = "Halley in a bracket",
                                   .problem = Problem::inverse_arc_length,
                                   .form = Form::bernstein,
                                   .promise = "the tolerance, or converged is no",
                                   .flops = "per iteration a length, a speed and a second derivative",
                                   .cost_exponent = 2,
                                   .citation = "[Traub 1964], section 5.2"};

  template <int Dimension>
  static InverseArcLength solve(const Curve<Form::bernstein, double, Dimension>& hodograph, double target,
                                double tolerance) {
    const auto velocity = HornerBernstein::prepare(hodograph);
    const auto acceleration = HornerBernstein::prepare(bezierbench::hodograph(hodograph, 1));
    std::int64_t evaluations = 0;
    const auto step = [&](double t, double distance) {
      evaluations += 2;
      const auto v = HornerBernstein::evaluate(velocity, t);
      const double speed = v.norm();
      const double change = v.dot(HornerBernstein::evaluate(acceleration, t)) / speed;
      return t - 2 * distance * speed / (2 * speed * speed - distance * change);
    };
    auto result = BracketedSearch<Dimension>(hodograph, target, tolerance).run(step);
    result.evaluations += evaluations;
    return result;
  }
};

}  // namespace bezierbench
