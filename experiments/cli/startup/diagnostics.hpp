// SPDX-License-Identifier: MIT
// Messages of the program on standard error.
#pragma once

#include <span>
#include <string>

#include "experiments/failure.hpp"

namespace bezierbench::cli {

/// Writes one line to standard error. `text` may come from a damaged file: line ends and other control characters are
/// escaped, and the middle of a very long word or text is left out. Does not throw where standard error cannot be written.
void say(const std::string& text);

/// Says each finding of a command; returns the exit code that they mean.
Exit say_findings(std::span<const std::string> findings);

}  // namespace bezierbench::cli
