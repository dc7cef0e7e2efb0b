// SPDX-License-Identifier: MIT
#include "experiments/suite/pattern.hpp"

#include <cstddef>

namespace bezierbench::suite {

bool matches(std::string_view pattern, std::string_view id) {
  std::size_t p = 0;
  std::size_t i = 0;
  std::size_t star = std::string_view::npos;  // the last `*` seen; only this one ever needs to match more characters
  std::size_t taken_to = 0;                   // the end of what that `*` matches in id
  while (i < id.size()) {
    if (p < pattern.size() && pattern[p] == '*') {
      star = p++;
      taken_to = i;
    } else if (p < pattern.size() && (pattern[p] == '?' || pattern[p] == id[i])) {
      ++p;
      ++i;
    } else if (star != std::string_view::npos) {
      p = star + 1;
      i = ++taken_to;
    } else {
      return false;
    }
  }
  return pattern.find_first_not_of('*', p) == std::string_view::npos;
}

bool is_peer(std::string_view id) { return id.starts_with("peer_"); }

bool means(std::string_view pattern, std::string_view id) {
  return matches(pattern, id) && (!is_peer(id) || is_peer(pattern));
}

bool is_pattern(std::string_view text) { return text.find_first_of("*?") != std::string_view::npos; }

}  // namespace bezierbench::suite
