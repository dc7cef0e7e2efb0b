// SPDX-License-Identifier: MIT
// The known word that is closest to a mistyped one, for "did you mean" in messages.
#pragma once

#include <span>
#include <string>
#include <string_view>

namespace bezierbench::suite {

/// The candidate with the fewest insertions, deletions, substitutions and swaps of neighbours from `word` (optimal
/// string alignment distance); of several, the first. Empty where this distance is more than a third of the word's
/// length, rounded up, for every candidate.
std::string nearest(std::string_view word, std::span<const std::string> candidates);

/// `; did you mean "..."?` with the nearest candidate. Where none is near, the candidates as `; known are a, b, c` (at
/// most twelve of them).
std::string suggestion(std::string_view word, std::span<const std::string> candidates);

}  // namespace bezierbench::suite
