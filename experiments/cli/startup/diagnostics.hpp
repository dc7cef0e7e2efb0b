// SPDX-License-Identifier: MIT
// What the program says to people, on standard error.
#pragma once

#include <string>

namespace bezierbench::cli {

/// One line on standard error, whatever `text` holds: line ends and other control characters, which a damaged file may
/// bring along, are escaped, and of megabytes the middle is left out. Never throws for a standard error that cannot be
/// written.
void say(const std::string& text);

}  // namespace bezierbench::cli
