// SPDX-License-Identifier: MIT
// Projection by the roots of one polynomial as eigenvalues of a companion matrix. The methods differ only in the
// polynomial: their `coefficients` returns its power coefficients for an OffsetCurve, ascending.
#pragma once

#include "core/project/companion_roots.hpp"
#include "core/project/nearest.hpp"

namespace bezierbench {

template <class Method>
struct CompanionProjection {
  template <int Dimension>
  static FootPoint project(const Curve<Form::bernstein, double, Dimension>& curve,
                           const Point<double, Dimension>& point) {
    const OffsetCurve<Dimension> offset(curve, point);
    return nearest(offset, companion_roots(Method::coefficients(offset)));
  }
};

}  // namespace bezierbench
