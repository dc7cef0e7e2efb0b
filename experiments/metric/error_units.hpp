// SPDX-License-Identifier: MIT
// Errors in the units in which they are judged and kept.
#pragma once

#include <algorithm>
#include <cmath>
#include <optional>

#include "core/curve_view.hpp"
#include "experiments/metric/tally.hpp"
#include "reference/certified_points.hpp"
#include "reference/error/trial_scale.hpp"

namespace bezierbench::metric {

using ErrorLanes = reference::CertifiedLanes;

/// in_units() of every trial of a group, rounded to 24 bits.
inline ErrorLanes in_units(const ErrorLanes& errors, const ErrorLanes& divisors, double unit = 1) {
  ErrorLanes units;
  for (std::size_t k = 0; k < units.size(); ++k)
    units[k] = to_24_bits(reference::in_units(errors[k], divisors[k], unit));
  return units;
}

/// The size of a curve: the largest extent of its control points along an axis. 0 in power form, whose coefficients are
/// not points. Coordinates are multiplied by `scale` before they are subtracted, and so is the size.
double size_of(const CurveView<double>& curve, double scale = 1);

/// How much larger than in an accuracy study errors may be where few other inputs are drawn from the same cell.
inline constexpr double observed_multiple = 16;

/// The largest error allowed, in units of u p~: that multiple of the largest one `observed` in the same cell, or of 1
/// if that is larger. Where none was observed, or an infinite one, half of the digits of the exact value must be right.
inline double allowed_error_u(std::optional<double> observed, double unit_roundoff) {
  if (observed && std::isfinite(*observed)) return observed_multiple * std::max(*observed, 1.0);
  return 1 / std::sqrt(unit_roundoff);
}

}  // namespace bezierbench::metric
