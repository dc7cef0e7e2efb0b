// SPDX-License-Identifier: MIT
// What the program says to people, on standard error.
#pragma once

#include <string>

namespace bezierbench::cli {

/// `text` as one line without its end: control characters, which a damaged file may bring along, become spaces.
std::string one_line(std::string text);

/// One line on standard error, whatever `text` holds: line ends and other control characters, which a damaged file may
/// bring along, become spaces. Never throws for a standard error that cannot be written.
void say(const std::string& text);

}  // namespace bezierbench::cli
