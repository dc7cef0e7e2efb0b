// SPDX-License-Identifier: MIT
// Regular expressions in memory and time that grow with the text, whatever a stranger wrote.
#pragma once

#include <string>

namespace bezierbench::bundle {

/// Whether `text` has a match of `pattern`, a POSIX extended regular expression; compiled once per pattern. A text with
/// a NUL byte has none. Throws std::invalid_argument for a pattern that is none.
[[nodiscard]] bool matches(const std::string& pattern, const std::string& text);

}  // namespace bezierbench::bundle
