// SPDX-License-Identifier: MIT
// The true control points of the two halves of a curve that is split at t.
//
// Control point i of the left half is the point at t of the curve whose control points are b_0..b_i, and control point
// i of the right half the point at t of the curve whose control points are b_i..b_n:
//   left_i = sum_(j=0..i) b_j B_j,i(t)        right_i = sum_(j=i..n) b_j B_(j-i),(n-i)(t)
// (the blossom values b[0^(n-i), t^i] and b[t^(n-i), 1^i]). Each is summed on its own in big integers, so no triangle
// is shared with the methods that are judged. Of a rational curve the weights of a half are the same sums over w_j, and
// its control points are those of w_j b_j over them: one scale for the whole curve, with the given weights at its ends.
#pragma once

#include <optional>
#include <vector>

#include "core/curve_view.hpp"
#include "reference/exact_curve.hpp"

namespace bezierbench::reference {

/// One half, exactly.
struct ExactHalf {
  std::vector<ExactPoint> points;  ///< n + 1 of them, not premultiplied; one does not exist where its weight is 0
  std::vector<Rational> weights;   ///< of a rational curve n + 1, else none
};

/// Both halves; the last point of `left` is the first of `right`.
struct ExactHalves {
  ExactHalf left;   ///< over [0, t]
  ExactHalf right;  ///< over [t, 1]
};

/// The halves of `curve` (Bernstein or rational form, finite coefficients and weights, dimension at most 3) at finite
/// t.
ExactHalves exact_split(const CurveView<double>& curve, double t);

/// p~ of each of those control points, the scale of its error: on each axis the sums above with |b_j| for b_j and the
/// magnitudes of the Bernstein values; of a rational curve sum |w_j b_j| |B_j(t)| over |weight of the point|, and of a
/// weight sum |w_j| |B_j(t)|.
ExactHalves split_p_tilde(const CurveView<double>& curve, double t);

/// Coordinates of points of the whole curve; none where there is no point, because the weights sum to zero.
struct Middles {
  std::vector<Rational> left;   ///< at t/2, where the left half has its parameter 1/2
  std::vector<Rational> right;  ///< at (1 + t)/2, likewise
};

/// The points of `curve` (as above) in the middle of each half; these parameters need not be doubles.
Middles exact_middles(const CurveView<double>& curve, double t);

/// |value - truth|, rounded once to `format`. Infinite where `value` is not finite or the difference overflows.
double error_of(double value, const Rational& truth, const Format& format);

// The control points of a part of a curve, and of a curve in a higher degree: the true ones, each coordinate and weight
// rounded once.

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
