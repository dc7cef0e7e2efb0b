// SPDX-License-Identifier: MIT
// Formula: p = (1-t)^n (c_0 + r (c_1 + r (c_2 + ...))), r = t/(1-t), for t <= 1/2; else
//   p = t^n (c_n + r (c_(n-1) + ...)), r = (1-t)/t; with c_i = C(n,i) b_i from `prepare`.
// Cost: one of the flops is a division.
// Bound: gamma_(4n+3) p~, and n more roundings past n = 54. Term i has 1 + binomial roundings in c_i. Each power of r
//   brings the rounding of a quotient; the rounding of 1-t in r^i and in (1-t)^n cancels to n-i. Horner's scheme has 2i
//   + 1, the power, by squaring, n-1, the last product 1: at most 4n + 2 + binomial roundings. (1-t)^n may underflow,
//   by up to 2^n max|b| eta. Horner's sum is at most 2^n max|b|, its product with the power (|t| + |1-t|)^n max|b|.
// Fails: the sum at r = 1 is up to 2^n max|b|, so a constant overflows past degree 1023 (127 in float). (1-t)^n
//   underflows for n > 1022 at t = 1/2.
#pragma once

#include <type_traits>

#include "core/binomial.hpp"
#include "core/bound/amplification.hpp"
#include "core/evaluate/methods/horner_bernstein.hpp"
#include "core/evaluate/schemes/nearer_end.hpp"
#include "core/evaluate/schemes/steps.hpp"
#include "core/vector/same_for_every_axis.hpp"
#include "core/vector/shared.hpp"

namespace bezierbench {

struct VolkSchumaker : SameForEveryAxis {
  static constexpr MethodInfo info{
      .id = "volk_schumaker",
      .label = "Volk-Schumaker",
      .form = Form::bernstein,
      .max_degree_float = 127,
      .bound =
          ErrorBound{.text = "gamma_(4n+3) p~, and n more roundings past n = 54",
                     .amplification = Amplification::p_tilde_bernstein,
                     .factor = [](int n, double u) { return gamma_over_u(4 * n + 3 + binomial_roundings(n, u), u); },
                     .underflow = [](int n) { return 4.0 * (n + 1) * (n + 1) * integer_power(2.0, n); },
                     .underflow_scales_with_coefficients = true,
                     .growth = [](int n) { return integer_power(2.0, n); }},
      .one_minus_t = OneMinusT::summed,
      .flops = "at most 2dn + d + 2 log2 n + 4",
      .citation = "[Schumaker and Volk 1986]"};
  static constexpr LaneRegisters lanes{.per_axis = 1, .shared = 2};

  static constexpr int largest_fixed_degree = 16;  ///< beyond, to count from the nearer end costs little

  template <class Scalar, int Dimension, int Degree>
  static auto prepare(const Curve<Form::bernstein, Scalar, Dimension, Degree>& curve) {
    return HornerBernstein::prepare(curve);
  }

  template <class Scalar, int Dimension, int Degree>
  static Point<Scalar, Dimension> evaluate(const HornerBernstein::Prepared<Scalar, Dimension, Degree>& prepared,
                                           Scalar t) {
    const auto& c = prepared.scaled;
    const int n = c.degree();
    const auto x = parameter_of(t);
    using Parameter = std::remove_const_t<decltype(x)>;
    const Parameter s = Parameter(1) - x;
    const auto near_start = x + x <= Parameter(1);
    const Parameter larger = select(near_start, s, x);
    const Scalar r(select(near_start, x, s) / larger);
    FromNearerEnd from_end(near_start, c);
    Point<Scalar, Dimension> p;
    for (int axis = 0; axis < Dimension; ++axis) p[axis] = from_end.counted_down(axis, n);
    count_down<Scalar, Degree>(n - 1, [&](int i) {
      for (int axis = 0; axis < Dimension; ++axis) p[axis] = p[axis] * r + from_end.counted_down(axis, i);
    });
    const Scalar scale(integer_power(larger, n));
    for (int axis = 0; axis < Dimension; ++axis) p[axis] *= scale;
    return p;
  }
};

}  // namespace bezierbench
