// SPDX-License-Identifier: MIT
// Projection by the roots of one polynomial as eigenvalues of a companion matrix. The methods differ only in the
// polynomial: their `coefficients` returns its power coefficients for an OffsetCurve, ascending. The nearest root is
// polished where the method states a `residual_bound`.
#pragma once

#include "core/project/companion_roots.hpp"
#include "core/project/nearest.hpp"
#include "core/project/refine.hpp"

namespace bezierbench {

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
