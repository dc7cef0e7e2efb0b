// SPDX-License-Identifier: MIT
// The messages of the program on standard error while and after it works. Errors of writing are ignored.
#pragma once

#include <string>
#include <string_view>

namespace bezierbench::run {

/// Writes one line, escaped by reference/number/echo.hpp. `head` is put before it, in colour on a terminal.
void note(const std::string& line, std::string_view head = {});

}  // namespace bezierbench::run
