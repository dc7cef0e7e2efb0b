// SPDX-License-Identifier: MIT
// Projection by the real roots of one polynomial: the methods differ in the polynomial, whose power coefficients
// `coefficients` returns for an OffsetCurve, ascending, and in the solver, `roots`. The nearest root is polished where
// the method states a `residual_bound`.
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/project/refine.hpp"

namespace bezierbench {

/// Candidates for the roots of a polynomial in [0, 1].
struct RootCandidates {
  std::vector<double> t;
  bool converged = true;  ///< false where the solver gave up before it had all roots
};

/// The coefficients without leading ones of at most u times the largest one; empty where all are 0. In [0, 1] this
/// changes the polynomial by no more than the rounding of the others did; solvers would divide by them.
inline std::vector<double> without_leading_zeros(std::vector<double> coefficients) {
  double largest = 0;
  for (const double coefficient : coefficients) largest = std::max(largest, std::abs(coefficient));
  while (!coefficients.empty() && std::abs(coefficients.back()) <= 0x1p-53 * largest) coefficients.pop_back();
  return coefficients;
}

template <class Method>
struct RootProjection {
  template <int Dimension>
  static FootPoint project(const Curve<Form::bernstein, double, Dimension>& curve,
                           const Point<double, Dimension>& point) {
    const OffsetCurve<Dimension> offset(curve, point);
    auto [candidates, converged] = Method::roots(without_leading_zeros(Method::coefficients(offset)));
    const auto best = nearest_candidate(offset, std::move(candidates));
    double t = best.t;
    if constexpr (requires { Method::residual_bound; }) t = polished(offset, t);
    return {t, offset.distance(t), best.candidates, converged};
  }
};

}  // namespace bezierbench
