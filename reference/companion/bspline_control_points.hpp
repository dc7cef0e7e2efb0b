// SPDX-License-Identifier: MIT
// The control points and knots of a whole B-spline curve or NURBS with knots inserted or removed, in a higher degree,
// of a part of it and of its derivative: the true ones, each coordinate and weight rounded once.
//
// Control point i of a curve of degree m over knots v is the blossom f(v_(i+1), ..., v_(i+m)) of any of its polynomial
// pieces on a span between v_i and v_(i+m+1), [Ramshaw 1987]. The pieces are those of the given curve, whose spans
// contain those of v. In a degree one higher the blossom is the mean of f over the arguments without one of them. Of a
// rational curve the numerators w_i d_i and the weights w_i are such curves.
//
// Every function first leaves out control points without influence on the curve, each with a knot. There are degree + 1
// knots up to the begin of a result and from its end on, and no knot stands more than degree + 1 times.
#pragma once

#include <gmpxx.h>

#include <optional>
#include <span>
#include <vector>

#include "core/bspline_curve.hpp"
#include "reference/exact_point.hpp"

namespace bezierbench::reference {

// Curves have finite knots, coordinates and weights, of dimension 1 to 3. A coordinate that overflows is infinite.
// Empty where a weight would not be positive after rounding.

/// With more knots, which may repeat, from the begin of the curve to its end. At an end the curve gets clamped.
std::optional<BsplineCurve> with_knots_inserted(const BsplineCurve& curve, std::span<const double> knots);

/// Over t in [from, to] within the curve, from < to, clamped: it begins and ends in its first and last control point.
/// Parts that meet where the curve is continuous share that point to the bit.
std::optional<BsplineCurve> part_of_bspline(const BsplineCurve& curve, double from, double to);

/// The highest degree to elevate to. Time grows with the fourth power of the degree and with the number of spans.
inline constexpr int max_elevated_bspline_degree = 64;

/// In `degree`, at least that of the curve and at most max_elevated_bspline_degree; each knot stands as many times
/// more.
std::optional<BsplineCurve> elevated_bspline(const BsplineCurve& curve, int degree);

/// The derivative of this order, 0 to degree - 1, of a polynomial curve. Control points of the first order are
///   m (d_(i+1) - d_i) / (u_(i+m+1) - u_(i+1)),    [Piegl and Tiller 1997], (3.8).
/// Where the curve jumps, the derivative is that of its pieces.
BsplineCurve derivative_of_bspline(const BsplineCurve& curve, int order);

struct KnotRemoval {
  BsplineCurve curve;
  /// No point at any t moves farther, rounding of the control points included; itself rounded up. 0 if and only if the
  /// knots can be removed without a change of the curve (of a rational one that is not a single point: of its
  /// numerators and its weights): then the control points are the true ones, each coordinate rounded once, and that is
  /// not counted. Infinite where a control point overflows.
  double deviation;
};

/// Without these knots, which stand in the curve between its begin and end; one that is named k times stands k times
/// less. New control points between those that stay are the blossoms of the piece before the knot in the first half,
/// and of the piece behind it in the second one, as in [Piegl and Tiller 1997], section 5.4. The deviation is the
/// largest distance of a control point after the knot is inserted again, for a curve is nearer to another one than
/// their control points over the same knots; but at most the diagonal of a box of the control points of both curves.
std::optional<KnotRemoval> with_knots_removed(const BsplineCurve& curve, std::span<const double> knots);

// The true points and Bernstein control points of a B-spline curve in one knot span: values of its blossom there.
//
// With 2m knots u_0 <= ... <= u_(2m-1) about the span from u_(m-1) to u_m, the blossoms of the basis functions at the
// arguments x_1..x_m follow from their definition by recurrence, one argument a degree, in fractions of big integers:
//   N_i^r(x_1..x_r) = (x_r - u_(m-r+i-1)) / (u_(m+i-1) - u_(m-r+i-1)) N_(i-1)^(r-1)(x_1..x_(r-1))
//                   + (u_(m+i) - x_r) / (u_(m+i) - u_(m-r+i)) N_i^(r-1)(x_1..x_(r-1)),        N_0^0 = 1.
// The point at t is the value for m times t, control point k that for m - k times u_(m-1) and k times u_m.

/// The values at one set of arguments, for any curve over these knots.
class ExactBsplineWeights {
 public:
  /// 2m finite knots, ascending, with a span between the middle ones that is not empty, and m finite arguments, m >= 1.
  ExactBsplineWeights(std::span<const double> knots, std::span<const double> arguments);

  /// At m times t.
  static ExactBsplineWeights at(std::span<const double> knots, double t);
  /// For control point k of the Bernstein form, 0 <= k <= m.
  static ExactBsplineWeights of_control_point(std::span<const double> knots, int k);

  /// Those of a rational curve with these m + 1 finite weights: w_i N_i / sum w_j N_j. The sum must not be zero.
  [[nodiscard]] ExactBsplineWeights with(std::span<const double> weights) const;

  /// m + 1 of them.
  [[nodiscard]] std::span<const mpq_class> values() const { return weights_; }

  /// The sum over m + 1 finite points, given point by point, of at most 3 coordinates. For arguments within the span no
  /// weight is negative, unless one in `with` is; magnitudes in place of coordinates then give the p~ of this value.
  [[nodiscard]] ExactPoint sum(int dimension, std::span<const double> control_points) const;

 private:
  std::vector<mpq_class> weights_;
};

}  // namespace bezierbench::reference
