// SPDX-License-Identifier: MIT
#pragma once

#include <string>

namespace bezierbench::run {

/// One line on standard error about how a run goes, whatever `line` holds; see experiments/echo.hpp. A standard error
/// that cannot be written is no reason to stop.
void note(const std::string& line);

}  // namespace bezierbench::run
