// SPDX-License-Identifier: MIT
// What all studies of lengths refuse.
#pragma once

#include <string_view>

#include "experiments/suite/suite.hpp"

namespace bezierbench::studies {

/// Throws Failure(usage) for curves without control points or with weights, for scalars but double, and for intervals
/// that leave [0, 1]; `interval` says what an interval is: "the part to be measured".
void check_lengths(const suite::Study& study, std::string_view interval);

}  // namespace bezierbench::studies
