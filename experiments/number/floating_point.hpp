// SPDX-License-Identifier: MIT
// Checks that floating-point arithmetic is what bounds and digests assume.
#pragma once

#include <string>
#include <vector>

namespace bezierbench::number {

/// The ways in which this process differs from IEEE 754 double arithmetic to nearest, one line each: contraction,
/// flushed subnormals, another rounding mode, excess precision. Empty where there is none.
std::vector<std::string> floating_point_faults();

}  // namespace bezierbench::number
