// SPDX-License-Identifier: MIT
// The true foot points of a point on a curve over [0, 1]: with dyadic input, f = (C - P).C' has integer coefficients,
// up to a power of two. All its real roots in [0, 1] are isolated with integers, so no minimum can be missed.
#pragma once

#include <span>
#include <vector>

#include "core/curve_view.hpp"
#include "reference/rational.hpp"

namespace bezierbench::reference {

/// A root of f in [0, 1], or an end of the curve.
struct CriticalPoint {
  Rational t;  ///< the root, or a dyadic number less than 2^-128 and less than half an ulp from it
  Rational
      distance_squared;  ///< at this t: the distance has an error below 2^-126 |C'|; 0 where the curve meets the point
};

struct ExactProjection {
  std::vector<CriticalPoint> critical;  ///< in ascending order of t, from t = 0 to t = 1
  std::size_t nearest = 0;              ///< index of the least distance; of equal ones the first

  [[nodiscard]] const CriticalPoint& foot() const { return critical[nearest]; }
};

/// Projects a finite point on a curve of as many dimensions: finite coefficients in Bernstein form, degree >= 1.
ExactProjection projection(const CurveView<double>& curve, std::span<const double> point);

/// |a - sqrt(b)| for a double a >= 0 and b >= 0, rounded once to `format`; the root is cut to 256 bits before.
double distance_error(const Format& format, double a, const Rational& b);

}  // namespace bezierbench::reference
