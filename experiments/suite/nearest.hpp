// SPDX-License-Identifier: MIT
// "Did you mean": the known word that is closest to a mistyped one.
#pragma once

#include <span>
#include <string>
#include <string_view>

namespace bezierbench::suite {

/// The candidate with the fewest insertions, deletions, substitutions and swaps of neighbours from `word` (optimal
/// string alignment distance); the first of equals. Empty where every candidate is further than a third of the word.
std::string nearest(std::string_view word, std::span<const std::string> candidates);

/// `; did you mean "..."?` for the nearest candidate; where nothing is close, the candidates themselves as
/// `; known are a, b, c` (at most twelve of them).
std::string suggestion(std::string_view word, std::span<const std::string> candidates);

}  // namespace bezierbench::suite
