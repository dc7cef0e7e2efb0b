// SPDX-License-Identifier: MIT
// Canary tests: whether floating-point arithmetic is what bounds and digests assume.
#pragma once

#include <string>
#include <vector>

namespace bezierbench::cli {

/// One line for each way in which this process does not compute as IEEE 754 double to nearest: contraction, flushed
/// subnormals, another rounding mode, excess precision. Empty where all is well.
std::vector<std::string> floating_point_faults();

}  // namespace bezierbench::cli
