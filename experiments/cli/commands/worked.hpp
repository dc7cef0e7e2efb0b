// SPDX-License-Identifier: MIT
// The worked conversions that [Report 001] prints, section 2.2, with its column "correct?", judged.
#pragma once

#include <string>

namespace bezierbench::cli {

/// The table of `list worked`: for each example and axis the printed control points and power coefficients, whether the
/// report calls them correct, whether they are, and how many conversions give the printed side from the other one.
std::string worked_csv();

}  // namespace bezierbench::cli
