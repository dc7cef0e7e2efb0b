// SPDX-License-Identifier: MIT
// Formula: compensated Horner on coefficients high q_j + low q_j: p = p t + high q_j error-free,
//   e = e t + (errors + low q_j); p + e.
// Bound: u |p| + gamma_(2n+3)^2 sum |q_j| |t|^j. Let k u and q u^2 bound, relative to this sum, the correction e and
//   the part that p + e misses. A step adds the two errors of its operations, so k grows by 2, and rounds e t twice,
//   each new error three times: q grows by 2k + 6. From k = 1 (the low part) n steps give 2n^2 + 6n, half of (2n+3)^2;
//   the other half covers higher orders. Two products a step may underflow, by eta/2 each, doubled as in
//   compensated_horner.
// Fails: at high degree, where (1+2t)^n u^2 reaches u (n of about 33 at t = 1).
#pragma once

#include "core/error_free.hpp"
#include "core/evaluate/evaluator.hpp"

namespace bezierbench {

struct HornerDoubleDouble : TakenAsGiven<Form::power_double_double> {
  static constexpr MethodInfo info{.id = "horner_dd",
                                   .label = "Horner, double-double coefficients",
                                   .form = Form::power_double_double,
                                   .bound = ErrorBound{.text = "u p~ + gamma_(2n+3)^2 sum |q_j| t^j",
                                                       .amplification = Amplification::p_tilde_power,
                                                       .factor =
                                                           [](int n, double u) {
                                                             const double gamma = gamma_over_u(2 * n + 3, u);
                                                             return gamma * gamma * u;
                                                           },
                                                       .underflow = [](int n) { return 2.0 * n; },
                                                       .growth = [](int n) { return n + 1.0; },
                                                       .result_roundings = 1},
                                   .fused = true,
                                   .flops = "12dn + d",
                                   .citation = "[Graillat et al. 2009], on double-double coefficients"};
  static constexpr LaneRegisters lanes{.per_axis = 2, .shared = 3};

  static constexpr int largest_fixed_degree = 2;  ///< beyond, its steps take longer than the loop around them

  template <class Scalar, int Dimension, int Degree>
  static Point<Scalar, Dimension> evaluate(const Curve<Form::power_double_double, Scalar, Dimension, Degree>& curve,
                                           Scalar t) {
    const int n = curve.degree();
    Point<Scalar, Dimension> p;
    Point<Scalar, Dimension> error;
    for (int axis = 0; axis < Dimension; ++axis) {
      p[axis] = curve.high(axis, n);
      error[axis] = curve.low(axis, n);
    }
    for (int j = n - 1; j >= 0; --j)
      for (int axis = 0; axis < Dimension; ++axis) {
        const auto product = two_prod<Scalar>(p[axis], t);
        const auto sum = two_sum<Scalar>(product.value, curve.high(axis, j));
        p[axis] = sum.value;
        error[axis] = error[axis] * t + ((product.error + sum.error) + curve.low(axis, j));
      }
    for (int axis = 0; axis < Dimension; ++axis) p[axis] += error[axis];
    return p;
  }
};

}  // namespace bezierbench
