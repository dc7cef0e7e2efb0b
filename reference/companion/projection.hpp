// SPDX-License-Identifier: MIT
// The true foot points of a point on a curve over [0, 1]: with dyadic input, f = (C - P).C' has integer coefficients,
// up to a power of two. All its real roots in [0, 1] are isolated with integers, so no minimum can be missed.
//
// Of a rational curve C = A / W let V = A - P W. Then C - P = V / W, and f = V.(V'W - VW') / W^3, whose numerator has
// degree 3n - 2: the terms of degree 2n - 1 in V'W - VW' cancel.
#pragma once

#include <span>
#include <vector>

#include "core/curve_view.hpp"
#include "reference/companion/integer_polynomial.hpp"
#include "reference/rational.hpp"

namespace bezierbench::reference {

/// A root of f in [0, 1], or an end of the curve.
struct CriticalPoint {
  Rational t;  ///< the root, or a dyadic number less than 2^-128 and less than half an ulp from it
  /// At this t: the distance has an error below 2^-126 |C'|, of a rational curve a relative one below 2^-256. 0 where
  /// the curve meets the point.
  Rational distance_squared;
};

struct ExactProjection {
  std::vector<CriticalPoint> critical;  ///< in ascending order of t, from t = 0 to t = 1
  std::size_t nearest = 0;              ///< index of the least distance; of equal ones the first

  [[nodiscard]] const CriticalPoint& foot() const { return critical[nearest]; }

  /// |C(t) - P|^2 = 2^(2 exponent) sum squared[i] t^i, for any t; of a rational curve over the square of `weight`.
  IntegerPolynomial squared;
  long exponent = 0;
  IntegerPolynomial weight;  ///< W up to a power of two, in which `squared` is, too; empty for other curves

  Rational largest_speed;       ///< n max |b_(i+1) - b_i|, a bound of |C'|, cut to 256 bits
  Rational largest_coordinate;  ///< of the control points and of P
  int degree = 0;

  /// At a finite t where W is not 0.
  [[nodiscard]] Rational distance_squared_at(double t) const;
};

/// Projects a finite point on a curve of as many dimensions: finite coefficients in Bernstein form, or in rational form
/// without a pole in [0, 1]; degree >= 1. Distances of a rational curve that agree to 1024 bits count as equal.
ExactProjection projection(const CurveView<double>& curve, std::span<const double> point);

/// The error of a foot point at t with its claimed distance, rounded once to `format`: |distance - d|, d the least
/// distance; or |C(t) - P| - d where that is more than twice as much. The rounding of a distance cannot explain such a
/// difference: the claimed distance may be right, but t is not. Infinite where t or distance is not finite.
double foot_error(const Format& format, double t, double distance, const ExactProjection& exact);

/// The residual |(C - P).C'| at t, over u D (|C - P| + D t + 2 n u M), with D `largest_speed`, M `largest_coordinate`
/// and u = 2^-53, rounded to `error_format`, for a curve that is not rational: these are a rounding of C', one of t
/// and, next to the curve, those of C - P that remain where u^2 counts. At an end from which the distance rises it is
/// 0, outside [0, 1] infinite.
double foot_residual(double t, const ExactProjection& exact);

/// |a - sqrt(b)| for a double a >= 0 and b >= 0, rounded once to `format`, with the root cut to 256 bits.
double distance_error(const Format& format, double a, const Rational& b);

}  // namespace bezierbench::reference
