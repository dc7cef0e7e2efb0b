// SPDX-License-Identifier: MIT
// The true range of the coordinates of a curve over [0, 1], on one axis: at the ends and at the roots of the derivative
// N'W - NW' of N / W, which has integer coefficients up to a power of two. All its real roots in [0, 1] are isolated
// with integers, so no extremum can be missed.
#pragma once

#include "core/curve_view.hpp"

namespace bezierbench::reference {

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
