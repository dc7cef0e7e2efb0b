// SPDX-License-Identifier: MIT
// Formula: with d_s the differences D^s p over k = 0, 1, ... of p(k/m): d_s = d_s + d_(s+1) for s = 0..n-1 is a step,
//   and d_0 the point. They begin as d_s = s! c_s, where c_s are the coefficients of p(x/m) in the basis 1, x, x (x-1),
//   ..., made of the power coefficients q_i / m^i by synthetic division by x, x-1, ..., x-(n-1).
// Cost: `prepare` takes d n^2.
// Bound: gamma_(2n+k) sum |q_j| t_k^j. Every path of a difference d_s(0) to d_0(k) passes one addition a step, so the
//   computed point is sum C(k,s) d_s(0), each path with its own k roundings. Division, sums and s! give a term of q_i
//   in d_s at most 2 (i-s) + s + s roundings, and sum_s C(k,s) s! S(i,s) = k^i with S(i,s) >= 0 (Stirling numbers)
//   leaves |q_i| (k/m)^i of all magnitudes. For Bernstein form q comes by `differences`, whose error adds as on a
//   converted path, with the same sum for the amplification. Only q_i / m^i may underflow: eta/2, which grows by k^i.
// Fails: the error grows with the number of steps, to about m u p~ at t = 1. Converted, it has the amplification of the
//   power form.
#pragma once

#include <cmath>

#include "core/convert/differences.hpp"
#include "core/factorial.hpp"
#include "core/grid/grid.hpp"
#include "core/powers.hpp"

namespace bezierbench {

/// The differences with which the scheme begins; column s holds D^s p.
template <int Dimension>
struct DifferencesOnGrid {
  Curve<Form::power, double, Dimension> first;
  int steps;
};

struct ForwardDifferencing {
  static constexpr GridBound bound{
      .text = "gamma_(2n+k) p~",
      .amplification = Amplification::p_tilde_power,
      .factor = [](int n, int k, double u) { return gamma_over_u(2.0 * n + k, u); },
      .underflow = [](int n, int steps) { return (n + 1) * integer_power(1.0 * steps, n); },
      .growth = [](int n, int steps) { return (n + 1) * integer_power(1 + 1.0 * n / steps, n); }};
  static constexpr MethodInfo info{.id = "forward_differencing",
                                   .label = "Forward differencing",
                                   .problem = Problem::grid,
                                   .form = Form::power,
                                   .max_degree = max_factorial,
                                   .promise = bound.text,
                                   .flops = "dn",
                                   .prepare_exponent = 2,
                                   .citation = "[Foley et al. 1990], section 11.2.9; bound derived here"};

  template <int Dimension>
  static DifferencesOnGrid<Dimension> prepare(const Curve<Form::power, double, Dimension>& curve, int steps) {
    const int n = curve.degree();
    const int bits = std::ilogb(steps);
    const auto factorial = factorials<double, dynamic>(n);
    DifferencesOnGrid<Dimension> prepared{curve, steps};
    auto& c = prepared.first;
    for (int axis = 0; axis < Dimension; ++axis) {
      for (int i = 0; i <= n; ++i) c(axis, i) = std::ldexp(c(axis, i), -bits * i);
      for (int node = 1; node < n; ++node)
        for (int i = n - 1; i >= node; --i) c(axis, i) += node * c(axis, i + 1);
      for (int s = 0; s <= n; ++s) c(axis, s) *= factorial[s];
    }
    return prepared;
  }

  template <int Dimension, class Take>
  static void run(const DifferencesOnGrid<Dimension>& prepared, Take take) {
    auto d = prepared.first;
    const int n = d.degree();
    Point<double, Dimension> point;
    for (int k = 0;; ++k) {
      for (int axis = 0; axis < Dimension; ++axis) point[axis] = d(axis, 0);
      take(k, point);
      if (k == prepared.steps) return;
      for (int s = 0; s < n; ++s)
        for (int axis = 0; axis < Dimension; ++axis) d(axis, s) += d(axis, s + 1);
    }
  }
};

/// The same for curves in Bernstein form.
struct ForwardDifferencingBernstein {
  static constexpr GridBound bound{
      .text = "conversion gamma_(n+1), steps gamma_(2n+k), times sum |b_i| C(n,i) t^i (1+t)^(n-i)",
      .amplification = Differences::info.bound->amplification,
      .factor =
          [](int n, int k, double u) {
            const double conversion = Differences::info.bound->factor(n, u);
            const double steps = ForwardDifferencing::bound.factor(n, k, u);
            return conversion + steps + conversion * u * steps;
          },
      .underflow = ForwardDifferencing::bound.underflow,
      .growth = [](int n, int steps) { return growth_to_power(n) * ForwardDifferencing::bound.growth(n, steps); }};
  static constexpr MethodInfo info = [] {
    auto data = ForwardDifferencing::info;
    data.form = Form::bernstein;
    data.promise = bound.text;
    return data;
  }();

  template <int Dimension>
  static DifferencesOnGrid<Dimension> prepare(const Curve<Form::bernstein, double, Dimension>& curve, int steps) {
    return ForwardDifferencing::prepare(Differences::convert(curve), steps);
  }

  template <int Dimension, class Take>
  static void run(const DifferencesOnGrid<Dimension>& prepared, Take take) {
    ForwardDifferencing::run(prepared, take);
  }
};

}  // namespace bezierbench
