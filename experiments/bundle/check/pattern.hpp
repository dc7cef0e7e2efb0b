// SPDX-License-Identifier: MIT
// Regular expressions whose memory and time grow only with the text, even for a stranger's text.
#pragma once

#include <string>

namespace bezierbench::bundle {

/// Whether some part of `text` matches `pattern`, a POSIX extended regular expression, which is compiled once. A text
/// with a NUL byte never matches. Throws std::invalid_argument for an invalid pattern.
[[nodiscard]] bool matches(const std::string& pattern, const std::string& text);

}  // namespace bezierbench::bundle
