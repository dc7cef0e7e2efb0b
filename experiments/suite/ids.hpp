// SPDX-License-Identifier: MIT
// Ids as people write them: globs over them, for `methods` in suites and `--only`, and the known one that is closest
// to a mistyped one, for "did you mean" in messages.
#pragma once

#include <span>
#include <string>
#include <string_view>

namespace bezierbench::suite {

/// Whether `pattern` matches all of `id`. `*` stands for any run of characters, also an empty one, `?` for exactly one,
/// and `[ab]` for one of these.
bool matches(std::string_view pattern, std::string_view id);

/// Whether `id` names a method of another library: such ids begin with `peer_`.
bool is_peer(std::string_view id);

/// Whether `pattern`, an entry of `methods`, names the method `id`. A glob matches peers only if it begins with `peer_`
/// itself: the meaning of `*` in a suite must not depend on the libraries that a machine happens to have.
bool means(std::string_view pattern, std::string_view id);

/// Whether `text` contains `*` or `?`.
bool is_pattern(std::string_view text);

/// The candidate with the fewest insertions, deletions, substitutions and swaps of neighbours from `word` (optimal
/// string alignment distance); of several, the first. Empty where this distance is more than a third of the word's
/// length, rounded up, for every candidate.
std::string nearest(std::string_view word, std::span<const std::string> candidates);

/// `; did you mean "..."?` with the nearest candidate. Where none is near, the candidates as `; known are a, b, c` (at
/// most twelve of them).
std::string suggestion(std::string_view word, std::span<const std::string> candidates);

}  // namespace bezierbench::suite
