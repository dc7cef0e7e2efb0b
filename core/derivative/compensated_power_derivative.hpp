// SPDX-License-Identifier: MIT
// Formula: C^(k)(t) = sum_(j>=k) (j)_k q_j t^(j-k), (j)_k = j (j-1) ... (j-k+1), whose coefficients are kept as pairs
//   high + low, by Horner's scheme on pairs (core/evaluate/methods/horner_dd.hpp).
// Cost: once (n-k+1)(k + 2d) flops.
// Bound: u |C^(k)| + gamma_(2m+3)^2 p~, m = n-k, and k more roundings of p~ where (n)_k is not below 2^53; here |C^(k)|
//   <= p~. Products with (j)_k are exact, the scheme is that of horner_dd. A product may underflow, by eta/2 for a
//   coefficient and by eta for each of two in a step.
// Fails: past a condition number of 1/u it loses digits again; where coefficients come from a rounded conversion.
#pragma once

#include <algorithm>

#include "core/derivative/derivative.hpp"
#include "core/evaluate/methods/horner_dd.hpp"
#include "core/factorial.hpp"

namespace bezierbench {

struct CompensatedPowerDerivative {
  static constexpr DerivativeBound bound{
      .text = "u p~ + gamma_(2(n-k)+3)^2 p~",
      .differences = [](int, int, double) { return 0.0; },
      .evaluation =
          [](int n, int k, double u) {
            const double result = falling_factorial(n, k) < 0x1p+53 ? 1 : gamma_over_u(k + 1, u);
            return result + HornerDoubleDouble::info.bound->factor(std::max(n - k, 0), u);
          },
      .underflow = [](int n, int) { return 3 * n + 1.0; },
      .growth = [](int n, int k) { return std::max(n - k, 0) + 1.0; }};
  static constexpr MethodInfo info{.id = "compensated_power_derivative",
                                   .label = "Power form, Horner, compensated",
                                   .problem = Problem::derivative,
                                   .form = Form::power,
                                   .promise = bound.text,
                                   .flops = "12d (n-k) + d",
                                   .prepare_exponent = 2,
                                   .citation = "[Graillat et al. 2009]; [Higham 2002], section 5.2"};

  template <int Dimension>
  static Curve<Form::power_double_double, double, Dimension> prepare(const Curve<Form::power, double, Dimension>& curve,
                                                                     int order) {
    const int n = curve.degree();
    Curve<Form::power_double_double, double, Dimension> derivative(std::max(n - order, 0));
    for (int j = 0; j <= derivative.degree(); ++j)
      for (int axis = 0; axis < Dimension; ++axis) {
        const auto product = order > n ? Expansion2<double>{0, 0}
                                       : two_prod(falling_factorial(j + order, order), curve(axis, j + order));
        derivative.high(axis, j) = product.value;
        derivative.low(axis, j) = product.error;
      }
    return derivative;
  }

  template <int Dimension>
  static Point<double, Dimension> evaluate(const Curve<Form::power_double_double, double, Dimension>& derivative,
                                           double t) {
    return HornerDoubleDouble::evaluate(derivative, t);
  }
};

}  // namespace bezierbench
