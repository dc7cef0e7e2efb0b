// SPDX-License-Identifier: MIT
// Formula: q_j = C(n,j) M^(n-j) D^j b_0 with forward differences D b_i = b_(i+1) - b_i, then midpoints
//   M b_i = (b_i + b_(i+1)) / 2, the n-j steps of de Casteljau at t = 1/2 on the j-th hodograph. The control points are
//   converted directly: shifting rounded power coefficients would keep their error.
// Cost: one triangle for each j. One triangle of midpoints and one of differences on its edge would suffice, but
//   amplify like (1 + 4|t-1/2|)^n.
// Bound: gamma_(n+1) times C(n,j) M^(n-j) (1 + E)^j |b_0|, whose sum core/bound/amplification.hpp derives. Each of the
//   n levels rounds once (halving is exact), then one product and the roundings of C(n,j) follow.
// Fails: its cost is cubic. The amplification reaches 2^n at both ends.
#pragma once

#include "core/binomial.hpp"
#include "core/convert/conversion.hpp"
#include "core/vector/same_for_every_axis.hpp"

namespace bezierbench {

struct DifferencesCentered : SameForEveryAxis {
  static constexpr MethodInfo info{
      .id = "differences_centered",
      .label = "Differences about t = 1/2",
      .problem = Problem::conversion,
      .form = Form::bernstein,
      .max_degree = max_degree_to_power,
      .max_degree_float = max_degree_to_power_float,
      .bound = ErrorBound{.text = "gamma_(n+1) sum |b_i| C(n,i) (1/2 + |t-1/2|)^n, and n more roundings past n = 54",
                          .amplification = Amplification::bernstein_to_centered,
                          .factor = [](int n, double u) { return gamma_over_u(n + 1 + binomial_roundings(n, u), u); },
                          .underflow = [](int n) { return 2 * (n + 1) * integer_power(2.0, n); },
                          .underflow_scales_with_coefficients = true,
                          .growth = growth_to_power},
      .flops = "d n(n+1)(2n+7)/6 + d(n+1) + 3n/2 per curve",
      .cost_exponent = 3,
      .citation = "[Farin 2002], derivatives by differences"};

  static constexpr Form target = Form::power_centered;
  static constexpr double coefficient_growth(int n) { return growth_to_power(n); }

  template <class Scalar, int Dimension, int Degree>
  static Curve<Form::power_centered, Scalar, Dimension, computed_degree<Degree>> convert(
      const Curve<Form::bernstein, Scalar, Dimension, Degree>& b) {
    const int n = b.degree();
    const BinomialRow<Scalar, computed_degree<Degree>> binomial(n);
    const Scalar half = Scalar(1) / Scalar(2);
    Curve<Form::bernstein, Scalar, Dimension, computed_degree<Degree>> difference(n);
    for (int i = 0; i <= n; ++i)
      for (int axis = 0; axis < Dimension; ++axis) difference(axis, i) = b(axis, i);
    Curve<Form::power_centered, Scalar, Dimension, computed_degree<Degree>> q(n);
    for (int j = 0; j <= n; ++j) {
      auto midpoint = difference;
      for (int level = 1; level <= n - j; ++level)
        for (int i = 0; i <= n - j - level; ++i)
          for (int axis = 0; axis < Dimension; ++axis)
            midpoint(axis, i) = half * (midpoint(axis, i) + midpoint(axis, i + 1));
      for (int axis = 0; axis < Dimension; ++axis) q(axis, j) = binomial[j] * midpoint(axis, 0);
      for (int i = 0; i < n - j; ++i)
        for (int axis = 0; axis < Dimension; ++axis)
          difference(axis, i) = difference(axis, i + 1) - difference(axis, i);
    }
    return q;
  }
};

}  // namespace bezierbench
