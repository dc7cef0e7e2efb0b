// SPDX-License-Identifier: MIT
#include "experiments/bundle/check/sums.hpp"

#include <optional>
#include <utility>

namespace bezierbench::bundle {
namespace {

// Name and digest in one line of sha256sum, text or binary mode; empty for any other line.
std::optional<std::pair<std::string, std::string>> parse_line(std::string_view line) {
  constexpr std::size_t digits = 64;
  if (line.size() < digits + 3) return std::nullopt;
  const std::string_view digest = line.substr(0, digits);
  if (digest.find_first_not_of("0123456789abcdef") != std::string_view::npos) return std::nullopt;
  const std::string_view mode = line.substr(digits, 2);
  if (mode != "  " && mode != " *") return std::nullopt;
  return std::pair(std::string(line.substr(digits + 2)), std::string(digest));
}

}  // namespace

Sums parse_sums(std::string_view text) {
  Sums sums;
  for (std::size_t line = 1; !text.empty(); ++line) {
    const std::size_t end = text.find('\n');
    const auto entry = parse_line(text.substr(0, end));
    // A missing line end means that the file was cut, even if the rest of the line can be read.
    if (!entry || end == std::string_view::npos || !sums.digests.insert(*entry).second) sums.malformed.push_back(line);
    text.remove_prefix(end == std::string_view::npos ? text.size() : end + 1);
  }
  return sums;
}

}  // namespace bezierbench::bundle
