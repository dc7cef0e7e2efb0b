// SPDX-License-Identifier: MIT
// Formula: p = q_n, e = 0; p = p t + q_j and e = e t + (errors of this product and this sum) for j = n-1..0; p + e.
// Bound: u |p| + gamma_2n^2 sum |q_j| |t|^j, the theorem of [Graillat et al. 2009], which excludes underflow. Two
//   products a step may underflow, by eta/2 each; this is doubled to cover second-order losses.
// Fails: coefficients that a rounded conversion made keep their error; horner_dd takes coefficients without it.
#pragma once

#include "core/error_free.hpp"
#include "core/evaluate/evaluator.hpp"

namespace bezierbench {

struct CompensatedHorner : TakenAsGiven<Form::power> {
  static constexpr MethodInfo info{.id = "compensated_horner",
                                   .label = "Horner, compensated",
                                   .form = Form::power,
                                   .bound = ErrorBound{.text = "u p~ + gamma_2n^2 p~",
                                                       .amplification = Amplification::p_tilde_power,
                                                       .factor =
                                                           [](int n, double u) {
                                                             const double gamma = gamma_over_u(2 * n, u);
                                                             return gamma * gamma * u;
                                                           },
                                                       .underflow = [](int n) { return 2.0 * n; },
                                                       .growth = [](int n) { return n + 1.0; },
                                                       .result_roundings = 1},
                                   .fused = true,
                                   .flops = "11dn + d",
                                   .citation = "[Graillat et al. 2009]"};
  static constexpr LaneRegisters lanes{.per_axis = 2, .shared = 3};

  static constexpr int largest_fixed_degree = 2;  ///< beyond, its steps take longer than the loop around them

  template <class Scalar, int Dimension, int Degree>
  static Point<Scalar, Dimension> evaluate(const Curve<Form::power, Scalar, Dimension, Degree>& curve, Scalar t) {
    const int n = curve.degree();
    Point<Scalar, Dimension> p;
    Point<Scalar, Dimension> error;
    for (int axis = 0; axis < Dimension; ++axis) {
      p[axis] = curve(axis, n);
      error[axis] = Scalar(0);
    }
    for (int j = n - 1; j >= 0; --j)
      for (int axis = 0; axis < Dimension; ++axis) {
        const auto product = two_prod<Scalar>(p[axis], t);
        const auto sum = two_sum<Scalar>(product.value, curve(axis, j));
        p[axis] = sum.value;
        error[axis] = error[axis] * t + (product.error + sum.error);
      }
    for (int axis = 0; axis < Dimension; ++axis) p[axis] += error[axis];
    return p;
  }
};

}  // namespace bezierbench
