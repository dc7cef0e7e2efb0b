// SPDX-License-Identifier: MIT
// Formula: p = c_0; p = fma(p, 1-t, c_i t^i) for i = 1..n, with c_i = C(n,i) b_i from `prepare` and t^i as a running
//   product.
// Bound: gamma_(2n+2) p~, and n more roundings past n = 54. Term i has 1 + binomial roundings in c_i, i-1 in t^i, 1
//   product, 1 fused step and 2 per later step (1-t and the step). The most are 2n + 1 + binomial roundings, for i = 1.
//   Underflow as for horner_bernstein.
// Keeps: as horner_bernstein, except for reversal. finite for n = 1: as in de_casteljau, with s W exact.
// Fails: as horner_bernstein.
#pragma once

#include "core/error_free.hpp"
#include "core/evaluate/guarantee.hpp"
#include "core/evaluate/methods/horner_bernstein.hpp"
#include "core/vector/same_for_every_axis.hpp"

namespace bezierbench {

struct HornerBernsteinFma : SameForEveryAxis {
  static constexpr MethodInfo info{
      .id = "horner_bernstein_fma",
      .label = "Horner-Bernstein, fused",
      .form = Form::bernstein,
      .max_degree_float = HornerBernstein::info.max_degree_float,
      .bound =
          ErrorBound{.text = "gamma_(2n+2) p~, and n more roundings past n = 54",
                     .amplification = Amplification::p_tilde_bernstein,
                     .factor = [](int n, double u) { return gamma_over_u(2 * n + 2 + binomial_roundings(n, u), u); },
                     .underflow = HornerBernstein::info.bound->underflow,
                     .underflow_scales_with_coefficients = true,
                     .growth = central_binomial},
      .fused = true,
      .one_minus_t = OneMinusT::summed,
      .flops = "n(1+2d) + 1",
      .citation = "[Farin 2002], nested multiplication, with fused steps"};
  static constexpr LaneRegisters lanes{.per_axis = 1, .shared = 1};

  static constexpr std::array guarantees{Guarantee{Property::ends_exact}, Guarantee{Property::finite, 1},
                                         Guarantee{Property::scaling_by_two}, Guarantee{Property::axes_independent},
                                         Guarantee{Property::total}};

  template <class Scalar, int Dimension, int Degree>
  using Prepared = HornerBernstein::Prepared<Scalar, Dimension, Degree>;

  template <class Scalar, int Dimension, int Degree>
  static auto prepare(const Curve<Form::bernstein, Scalar, Dimension, Degree>& curve) {
    return HornerBernstein::prepare(curve);
  }

  template <class Scalar, int Dimension, int Degree>
  static Point<Scalar, Dimension> evaluate(const HornerBernstein::Prepared<Scalar, Dimension, Degree>& prepared,
                                           Scalar t) {
    return nested(prepared.scaled, t);
  }

  /// The nested multiplication of C(n,i) b_i, in whatever holds them.
  template <Form F, class Scalar, int Dimension, int Degree>
  static Point<Scalar, Dimension> nested(const Curve<F, Scalar, Dimension, Degree>& scaled, const Scalar& t) {
    const int n = scaled.degree();
    const Scalar s = Scalar(1) - t;
    Point<Scalar, Dimension> p;
    for (int axis = 0; axis < Dimension; ++axis) p[axis] = scaled(axis, 0);
    Scalar t_power = Scalar(1);
    count_down<Scalar, Degree>(n - 1, [&](int left) {
      t_power *= t;
      for (int axis = 0; axis < Dimension; ++axis)
        p[axis] = fused<Scalar>(p[axis], s, scaled.from_end(axis, left) * t_power);
    });
    return p;
  }
};

}  // namespace bezierbench
