// SPDX-License-Identifier: MIT
// Messages of the program on standard error.
#pragma once

#include <string>

namespace bezierbench::cli {

/// Writes one line to standard error. Line ends and other control characters in `text`, which may come from a damaged
/// file, are escaped; the middle of a very long text is left out. Does not throw where standard error cannot be
/// written.
void say(const std::string& text);

}  // namespace bezierbench::cli
