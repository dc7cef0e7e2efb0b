// SPDX-License-Identifier: MIT
// Files of curves as commands read them.
#pragma once

#include <string>

#include "reference/curves/read.hpp"

namespace bezierbench::cli {

/// The curves of a file of any kind that curves::read takes; `-` is standard input. Throws Failure(input_output).
curves::Read read_curve_set(const std::string& file, const curves::ReadOptions& options = {});

}  // namespace bezierbench::cli
