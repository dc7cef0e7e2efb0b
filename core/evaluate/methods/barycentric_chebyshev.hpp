// SPDX-License-Identifier: MIT
// Formula: the second barycentric form (barycentric.hpp) with Chebyshev nodes of the second kind,
//   x_j = (1 - cos(j pi/n)) / 2, j = 0..n.
// Source: [Berrut and Trefethen 2004], section 5, has the nodes.
// Nodes: an alternating series in + - * / computes them, so that no libm decides a bit: (1 - cos y)/2 = y^2/4 r_1,
//   r_k = 1 - y^2/((2k+1)(2k+2)) r_(k+1), y = j pi/n <= pi/2, whose first dropped term is below 2^-63. The error of y
//   is at most 2.4 u and moves x by 1/2 y sin(y) <= pi/4 times that, 1.9 u; the roundings of the series add 2.2 u, the
//   last one u/2. Nodes are within 4.6 u of the exact ones (observed: 2.1 u), in float within 0.51 u. They are
//   symmetric, and both ends are nodes.
// Bound: (4n+7) u (1 + 2/pi ln(n+1)) max|b| on [0,1], to first order: barycentric.hpp with the Lebesgue constant of
//   [Ehlich and Zeller 1966]. This bound is not a multiple of p~, so `info` states no bound.
// Fails: where p~ is far below max|b|, for the error is relative to max|b|. Outside [0,1] the error grows like the
//   Lagrange polynomials of the nodes, with (|s| + sqrt(s^2 - 1))^n at s = 2t - 1.
#pragma once

#include "core/evaluate/schemes/barycentric.hpp"

namespace bezierbench {

/// (1 - cos(j pi/n)) / 2 for 0 <= 2j <= n.
constexpr double chebyshev_node(int j, int n) {
  constexpr double pi = 0x1.921fb54442d18p+1;
  const double y = pi * j / n;
  const double square = y * y;
  double series = 1;
  for (int k = 11; k >= 1; --k) series = 1 - square / ((2 * k + 1) * (2 * k + 2)) * series;
  return square / 4 * series;
}

struct BarycentricChebyshev {
  static constexpr MethodInfo info{.id = "barycentric_chebyshev",
                                   .label = "Barycentric, Chebyshev nodes",
                                   .form = Form::bernstein,
                                   .flops = "(n+1)(3+2d) + d, n+1+d of them divisions",
                                   .prepare_exponent = 2,
                                   .citation =
                                       "[Berrut and Trefethen 2004], eq. (4.2); [Fuda et al. 2024], "
                                       "CHE"};
  static constexpr LaneRegisters lanes{.per_axis = 1, .shared = 2, .one_curve_only = true};

  static constexpr int largest_fixed_degree = 2;  ///< beyond, its division takes longer than the loop around it

  template <class Scalar, int Dimension, int Degree>
  static Barycentric<Scalar, Dimension, Degree> prepare(
      const Curve<Form::bernstein, Scalar, Dimension, Degree>& curve) {
    const int n = curve.degree();
    return prepare_barycentric(curve, detail::mirrored_nodes<Scalar, Degree>(
                                          n, [n](int j) { return detail::PerCurve<Scalar>(chebyshev_node(j, n)); }));
  }

  template <class Scalar, int Dimension, int Degree>
  static Point<Scalar, Dimension> evaluate(const Barycentric<Scalar, Dimension, Degree>& prepared, Scalar t) {
    return evaluate_barycentric(prepared, t);
  }
};

}  // namespace bezierbench
