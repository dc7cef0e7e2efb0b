// SPDX-License-Identifier: MIT
// The control points of a part of a curve, and of a curve in a higher degree: the true ones, each coordinate and weight
// rounded once.
#pragma once

#include <optional>
#include <vector>

#include "core/curve_view.hpp"

namespace bezierbench::reference {

struct RoundedControlPoints {
  std::vector<double> points;   ///< point by point, not premultiplied; infinite where a coordinate overflows
  std::vector<double> weights;  ///< of a rational curve, in the scale of its own; otherwise none
};

// Curves are in Bernstein or rational form with finite coefficients and weights. Empty where the weight of a control
// point would be rounded to 0.

/// Over t from `from` to `to`, which are finite, may lie outside of [0, 1], and may fall: from 1 to 0 is the reversed
/// curve. Control point i is the value b[from^(n-i), to^i] of the blossom, so that parts that meet share their end to
/// the bit. Its cost is cubic in the degree.
std::optional<RoundedControlPoints> control_points_of_part(const CurveView<double>& curve, double from, double to);

/// In `degree`, at least that of the curve: with r more degrees control point i is
///   sum_j C(n,j) C(r,i-j) / C(n+r,i) b_j.
std::optional<RoundedControlPoints> elevated_control_points(const CurveView<double>& curve, int degree);

}  // namespace bezierbench::reference
