// SPDX-License-Identifier: MIT
// Globs over ids, for `methods` in suites and `--only`.
#pragma once

#include <string_view>

namespace bezierbench::suite {

/// Whether all of `id` fits `pattern`: `*` stands for any run of characters, also none, `?` for exactly one.
bool matches(std::string_view pattern, std::string_view id);

/// Whether the method is another library's: such ids begin with `peer_`.
bool is_peer(std::string_view id);

/// Whether `pattern`, an entry of `methods`, means the method `id`. A glob means peers only where it begins with
/// `peer_` itself: what a suite with `*` does must not depend on the libraries that a machine happens to have.
bool means(std::string_view pattern, std::string_view id);

/// Whether `text` has a `*` or `?`.
bool is_pattern(std::string_view text);

}  // namespace bezierbench::suite
