// SPDX-License-Identifier: MIT
#pragma once

#include <string>

namespace bezierbench::run {

/// Writes one line about the run to standard error, escaped by experiments/echo.hpp. Errors of writing are ignored.
void note(const std::string& line);

}  // namespace bezierbench::run
