// SPDX-License-Identifier: MIT
// SHA256SUMS: the list of a bundle's files with their checksums.
#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace bezierbench::bundle {

struct Sums {
  std::map<std::string, std::string> digests;  ///< by file name
  std::vector<std::size_t> malformed;          ///< lines, from 1, that are invalid, cut, or repeat a name
};

/// Parses the text of SHA256SUMS.
[[nodiscard]] Sums parse_sums(std::string_view text);

}  // namespace bezierbench::bundle
