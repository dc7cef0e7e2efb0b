// SPDX-License-Identifier: MIT
// Projection by the roots of one polynomial as eigenvalues of a companion matrix. The methods differ only in the
// polynomial: their `coefficients` returns its power coefficients for an OffsetCurve, ascending. The nearest root is
// polished where the method states a `residual_bound`.
#pragma once

#include <vector>

#include "core/project/nearest.hpp"
#include "core/project/refine.hpp"

namespace bezierbench {

// Candidates from the eigenvalues of a companion matrix, which Eigen balances and iterates. The bits of Eigen's
// iterations depend on how Eigen was built, so methods that use it are not bit-stable.

/// Candidates for the roots of sum coefficients[k] t^k in [0, 1]: the real parts in [0, 1] of all complex roots. They
/// include a double root that rounding has split into a pair. A superfluous candidate costs one comparison of
/// distances.
///
/// Leading coefficients of at most u times the largest one are dropped. In [0, 1] this changes the polynomial by no
/// more than the rounding of the others did; the companion matrix would divide by them.
std::vector<double> companion_roots(std::vector<double> coefficients);

template <class Method>
struct CompanionProjection {
  template <int Dimension>
  static FootPoint project(const Curve<Form::bernstein, double, Dimension>& curve,
                           const Point<double, Dimension>& point) {
    const OffsetCurve<Dimension> offset(curve, point);
    const auto best = nearest_candidate(offset, companion_roots(Method::coefficients(offset)));
    double t = best.t;
    if constexpr (requires { Method::residual_bound; }) t = polished(offset, t);
    return {t, offset.distance(t), best.candidates, true};
  }
};

}  // namespace bezierbench
