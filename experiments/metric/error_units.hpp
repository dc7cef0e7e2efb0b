// SPDX-License-Identifier: MIT
// Errors in the units in which they are judged and kept.
#pragma once

#include "reference/certified_points.hpp"

namespace bezierbench::metric {

using ErrorLanes = reference::CertifiedLanes;

/// reference::in_units() of every trial of a group, rounded to 24 bits.
ErrorLanes in_units(const ErrorLanes& errors, const ErrorLanes& divisors, double unit = 1);

}  // namespace bezierbench::metric
