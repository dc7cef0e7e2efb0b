// SPDX-License-Identifier: MIT
// Formula: t <- t - 2 d s' / (2 s'^2 - d s''), d = s(t) - S, s' = |C'|, s'' = C'.C'' / |C'|, in the bracket of
//   bracketed_newton. A step out of the interval, or one after which the distance was not halved, is a bisection.
// Bound: as bracketed_newton.
// Converges: cubically where |C'| > 0. As each length costs far more than a derivative, an iteration saved pays.
// Fails: as bracketed_newton.
#pragma once

#include "core/arc_length/inverse/bracket.hpp"
#include "core/derivative/hodograph.hpp"
#include "core/evaluate/methods/horner_bernstein.hpp"

namespace bezierbench {

/// A speed and its derivative.
struct Pace {
  double speed;
  double change;
};

/// Both at any t.
template <int Dimension>
auto pace_of(const Curve<Form::bernstein, double, Dimension>& h) {
  return [velocity = HornerBernstein::prepare(h), acceleration = HornerBernstein::prepare(hodograph(h, 1))](double t) {
    const auto v = HornerBernstein::evaluate(velocity, t);
    const double speed = v.norm();
    return Pace{speed, v.dot(HornerBernstein::evaluate(acceleration, t)) / speed};
  };
}

/// (|U| / W^2)' = (|U|' - 2 |U| W' / W) / W^2.
template <int Dimension>
auto pace_of(const RationalPanel<Dimension>& panel) {
  return [of_vectors = pace_of(panel.h), weight = HornerBernstein::prepare(panel.w),
          slope = HornerBernstein::prepare(hodograph(panel.w, 1))](double t) {
    const auto [size, change] = of_vectors(t);
    const double w = HornerBernstein::evaluate(weight, t)[0];
    const double of_weight = 2 * size * HornerBernstein::evaluate(slope, t)[0] / w;
    return Pace{size / (w * w), (change - of_weight) / (w * w)};
  };
}

struct Halley {
  static constexpr MethodInfo info{.id = "halley",
                                   .label = "Halley in a bracket",
                                   .problem = Problem::inverse_arc_length,
                                   .form = Form::bernstein,
                                   .promise = "the tolerance, or converged is no",
                                   .flops = "per iteration a length, a speed and a second derivative",
                                   .cost_exponent = 2,
                                   .citation = "[Traub 1964], section 5.2"};

  template <class Hodograph>
  static InverseArcLength solve(const Hodograph& hodograph, double target, double tolerance) {
    const auto pace = pace_of(hodograph);
    std::int64_t evaluations = 0;
    const auto step = [&](double t, double distance) {
      evaluations += 2;
      const auto [speed, change] = pace(t);
      return t - 2 * distance * speed / (2 * speed * speed - distance * change);
    };
    auto result = BracketedSearch(hodograph, target, tolerance).run(step);
    result.evaluations += evaluations;
    return result;
  }
};

}  // namespace bezierbench
