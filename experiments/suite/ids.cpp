// SPDX-License-Identifier: MIT
#include "experiments/suite/ids.hpp"

#include <fmt/format.h>
#include <fnmatch.h>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <numeric>
#include <utility>
#include <vector>

namespace bezierbench::suite {

bool matches(std::string_view pattern, std::string_view id) {
  return ::fnmatch(std::string(pattern).c_str(), std::string(id).c_str(), FNM_NOESCAPE) == 0;
}

bool is_peer(std::string_view id) { return id.starts_with("peer_"); }

bool means(std::string_view pattern, std::string_view id) {
  return matches(pattern, id) && (!is_peer(id) || is_peer(pattern));
}

bool is_pattern(std::string_view text) { return text.find_first_of("*?") != std::string_view::npos; }

namespace {

std::size_t distance(std::string_view a, std::string_view b) {
  std::vector<std::size_t> before(b.size() + 1), above(b.size() + 1), row(b.size() + 1);
  std::iota(above.begin(), above.end(), std::size_t{0});
  for (std::size_t i = 1; i <= a.size(); ++i) {
    row[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      row[j] = std::min({above[j] + 1, row[j - 1] + 1, above[j - 1] + (a[i - 1] == b[j - 1] ? 0U : 1U)});
      const bool swapped = i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1];
      if (swapped) row[j] = std::min(row[j], before[j - 2] + 1);
    }
    std::swap(before, above);
    std::swap(above, row);
  }
  return above[b.size()];
}

}  // namespace

std::string nearest(std::string_view word, std::span<const std::string> candidates) {
  const std::size_t furthest = std::max<std::size_t>(1, (word.size() + 2) / 3);
  std::size_t best = std::numeric_limits<std::size_t>::max();
  std::string found;
  for (const std::string& candidate : candidates) {
    const std::size_t longer = std::max(word.size(), candidate.size()) - std::min(word.size(), candidate.size());
    if (longer > furthest) continue;  // at least `longer` insertions; saves minutes on a very long word
    const std::size_t d = distance(word, candidate);
    // At a distance of its whole length, a candidate shares no letter with the word.
    if (d <= furthest && d < best && d < candidate.size()) {
      best = d;
      found = candidate;
    }
  }
  return found;
}

std::string suggestion(std::string_view word, std::span<const std::string> candidates) {
  if (const std::string near = nearest(word, candidates); !near.empty())
    return fmt::format("; did you mean \"{}\"?", near);
  if (candidates.empty()) return "; none is known here";
  constexpr std::size_t most = 12;
  const auto shown = candidates.first(std::min(most, candidates.size()));
  return fmt::format("; known are {}{}", fmt::join(shown, ", "), candidates.size() > most ? ", ..." : "");
}

}  // namespace bezierbench::suite
