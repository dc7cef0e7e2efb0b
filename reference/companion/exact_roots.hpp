// SPDX-License-Identifier: MIT
// Where a coordinate of a curve has a value, where it is stationary, and where a plane curve has an inflection: the
// roots in [0, 1] of polynomials with integer coefficients, isolated with their multiplicities. None can be missed.
//
// With the curve as N / W, W = 1 where it is not rational, and without a root of W in [0, 1] (see `pole`):
//   value v      N - v W
//   extrema      N'W - NW', the numerator of (N / W)'
//   inflections  det(P, P', P''), P = (X, Y, W), which is W^3 (x'y'' - x''y')
#pragma once

#include <optional>
#include <vector>

#include "core/curve_view.hpp"

namespace bezierbench::reference {

struct Root {
  double t;          ///< rounded once
  int multiplicity;  ///< an odd one changes the sign
};

/// The roots, ascending.
struct Roots {
  bool everywhere = false;  ///< every t is a root; `roots` is then empty
  std::vector<Root> roots;
};

// Curves are in Bernstein, power or rational form, with finite coefficients and, if rational, without a pole in [0, 1].

/// Where the coordinate is `value`, which is finite.
Roots roots_of_value(const CurveView<double>& curve, int axis, double value);

/// Where the derivative of the coordinate is 0: its extrema, with the ends only where they are stationary.
Roots roots_of_derivative(const CurveView<double>& curve, int axis);

/// Where x'y'' - x''y' of a curve in the plane is 0. At a point with a tangent an odd multiplicity is an inflection,
/// an even one a flat point; an ordinary cusp has 2.
Roots roots_of_curvature(const CurveView<double>& curve);

// Where a rational curve has a pole: the roots of its denominator, isolated with integers.

/// The first parameter in [from, to], part of [0, 1], at which the weights of a rational curve sum to zero, to some 53
/// bits; empty where there is none, and for other curves. Coefficients are finite.
std::optional<double> pole(const CurveView<double>& curve, double from = 0, double to = 1);

// The true range of the coordinates of a curve over [0, 1], on one axis: at the ends and at the roots of the derivative
// N'W - NW' of N / W, which has integer coefficients up to a power of two. All its real roots in [0, 1] are isolated
// with integers, so no extremum can be missed.

/// The tightest range of doubles that contains the coordinates: the largest double that none is below, and the smallest
/// that none is above.
struct ExactRange {
  double low;
  double high;
};

/// Of a curve in Bernstein or rational form with finite coefficients and weights > 0. An extremum whose value is a
/// double is found to be one by a common root with the derivative; any other is enclosed until the enclosure lies
/// between two neighbouring doubles.
ExactRange exact_range(const CurveView<double>& curve, int axis);

}  // namespace bezierbench::reference
