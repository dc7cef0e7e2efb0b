// SPDX-License-Identifier: MIT
// Formula: C^(k)(t) = sum_(j>=k) j (j-1) ... (j-k+1) q_j t^(j-k), by Horner's scheme.
// Cost: once (n-k+1)(k + d) flops.
// Bound: gamma_(k+2(n-k)) p~: each coefficient has k roundings, Horner's scheme 2(n-k). Products may underflow, by
//   eta/2 each.
// Fails: like any power form, where its coefficients come from a rounded conversion.
#pragma once

#include <algorithm>

#include "core/derivative/derivative.hpp"
#include "core/evaluate/methods/horner.hpp"
#include "core/factorial.hpp"

namespace bezierbench {

struct PowerDerivative {
  static constexpr DerivativeBound bound{
      .text = "gamma_(k+2(n-k)) p~",
      .differences = [](int, int, double) { return 0.0; },
      .evaluation = [](int n, int k, double u) { return gamma_over_u(std::min(n, k) + 2 * std::max(n - k, 0), u); },
      .underflow = [](int n, int) { return n + 1.0; },
      .growth = [](int n, int k) { return std::max(n - k, 0) + 1.0; }};
  static constexpr MethodInfo info{.id = "power_derivative",
                                   .label = "Power form, Horner",
                                   .problem = Problem::derivative,
                                   .form = Form::power,
                                   .promise = bound.text,
                                   .flops = "2d (n-k)",
                                   .prepare_exponent = 2,
                                   .citation = "[Higham 2002], section 5.2"};

  template <int Dimension>
  static Curve<Form::power, double, Dimension> prepare(const Curve<Form::power, double, Dimension>& curve, int order) {
    const int n = curve.degree();
    Curve<Form::power, double, Dimension> derivative(std::max(n - order, 0));
    for (int j = 0; j <= derivative.degree(); ++j)
      for (int axis = 0; axis < Dimension; ++axis)
        derivative(axis, j) = order > n ? 0 : falling_factorial(j + order, order) * curve(axis, j + order);
    return derivative;
  }

  template <int Dimension>
  static Point<double, Dimension> evaluate(const Curve<Form::power, double, Dimension>& derivative, double t) {
    return Horner::evaluate(derivative, t);
  }
};

}  // namespace bezierbench
