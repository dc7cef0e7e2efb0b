// SPDX-License-Identifier: MIT
// Errors in the units in which they are judged and kept.
#pragma once

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

/// The size of a curve: the largest extent of its control points along an axis. 0 in power form, whose coefficients are not
/// points. Coordinates are multiplied by `scale` before they are subtracted, and so is the size.
double size_of(const CurveView<double>& curve, double scale = 1);

}  // namespace bezierbench::metric
