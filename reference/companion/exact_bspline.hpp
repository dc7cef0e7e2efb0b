// SPDX-License-Identifier: MIT
// The true points and Bernstein control points of a B-spline curve in one knot span: values of its blossom there.
//
// With 2m knots u_0 <= ... <= u_(2m-1) about the span from u_(m-1) to u_m, the blossoms of the basis functions at the
// arguments x_1..x_m follow from their definition by recurrence, one argument a degree, in fractions of big integers:
//   N_i^r(x_1..x_r) = (x_r - u_(m-r+i-1)) / (u_(m+i-1) - u_(m-r+i-1)) N_(i-1)^(r-1)(x_1..x_(r-1))
//                   + (u_(m+i) - x_r) / (u_(m+i) - u_(m-r+i)) N_i^(r-1)(x_1..x_(r-1)),        N_0^0 = 1.
// The point at t is the value for m times t, control point k that for m - k times u_(m-1) and k times u_m.
#pragma once

#include <gmpxx.h>

#include <span>
#include <vector>

#include "reference/exact_point.hpp"

namespace bezierbench::reference {

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
