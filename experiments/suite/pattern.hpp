// SPDX-License-Identifier: MIT
// Globs over ids, for `methods` in suites and `--only`.
#pragma once

#include <string_view>

namespace bezierbench::suite {

/// Whether all of `id` fits `pattern`: `*` stands for any run of characters, also none, `?` for exactly one.
bool matches(std::string_view pattern, std::string_view id);

/// Whether `text` has a `*` or `?`.
bool is_pattern(std::string_view text);

}  // namespace bezierbench::suite
