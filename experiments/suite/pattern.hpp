// SPDX-License-Identifier: MIT
// Globs over ids, for `methods` in suites and `--only`.
#pragma once

#include <string_view>

namespace bezierbench::suite {

/// Whether `pattern` matches all of `id`. `*` stands for any run of characters, also an empty one, `?` for exactly one.
bool matches(std::string_view pattern, std::string_view id);

/// Whether `id` names a method of another library: such ids begin with `peer_`.
bool is_peer(std::string_view id);

/// Whether `pattern`, an entry of `methods`, names the method `id`. A glob matches peers only if it begins with `peer_`
/// itself: the meaning of `*` in a suite must not depend on the libraries that a machine happens to have.
bool means(std::string_view pattern, std::string_view id);

/// Whether `text` contains `*` or `?`.
bool is_pattern(std::string_view text);

}  // namespace bezierbench::suite
