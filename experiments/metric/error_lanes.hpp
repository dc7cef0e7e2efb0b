// SPDX-License-Identifier: MIT
// The errors of a group of trials in the units in which they are kept.
#pragma once

#include "reference/certified_points.hpp"

namespace bezierbench::metric {

using ErrorLanes = reference::CertifiedLanes;

/// error / divisor / unit of every lane, rounded to 24 bits. 0 / 0 is 0: no error, or nothing that an error could be
/// measured with.
ErrorLanes in_units(const ErrorLanes& errors, const ErrorLanes& divisors, double unit = 1);

}  // namespace bezierbench::metric
