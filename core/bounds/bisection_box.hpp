// SPDX-License-Identifier: MIT
// Formula: the ends, and p(t) by de Casteljau at each t where the derivative changes its sign, found by halving and
//   bisection. A rational curve: the same with N'W - NW', and N(t) / W(t).
// Cost: per extremum, which takes 52 bisections of n(n-1)/2 d flops, and four times that of a rational curve.
// Bound: none.
// Fails: the box may be too small by the roundings of t and p(t); an extremum is lost where the roundings of the
//   derivative hide both changes of its sign; w_i b_i and products of weights may leave the range.
#pragma once

#include "core/bounds/extrema_parameters.hpp"

namespace bezierbench {

template <Form F>
struct BisectionBox {
  static constexpr BoxPromises promises{.contains = false, .within_one_ulp = false};
  static constexpr MethodInfo info{.id = "bisection_box",
                                   .label = "Extrema by sign changes and bisection",
                                   .problem = Problem::bounds,
                                   .form = F,
                                   .max_degree = F == Form::rational ? 500 : bezierbench::max_degree,
                                   .flops = F == Form::rational ? "104n(n-1)d" : "26n(n-1)d",
                                   .cost_exponent = 3,
                                   .citation = "[Lane and Riesenfeld 1981]"};

  static Range range(const Curve<F, double, 1>& axis) {
    if (!stays_in_hull(axis)) return whole_axis;
    Range range = range_of_ends(axis);
    const int n = axis.degree();
    std::vector<double> numerator;
    std::vector<double> denominator;
    for (int i = 0; i <= n; ++i) {
      if constexpr (F == Form::rational) {
        numerator.push_back(axis.weights[i] * axis.points(0, i));
        denominator.push_back(axis.weights[i]);
      } else {
        numerator.push_back(axis(0, i));
      }
    }
    each_extremum(axis, [&](double t) {
      const double value = bernstein_value(numerator, t);
      range.include(F == Form::rational ? value / bernstein_value(denominator, t) : value);
    });
    return range;
  }
};

}  // namespace bezierbench
