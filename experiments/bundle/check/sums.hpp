// SPDX-License-Identifier: MIT
// SHA256SUMS: a bundle's own list of its files.
#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace bezierbench::bundle {

struct Sums {
  std::map<std::string, std::string> digests;  ///< by name of the file
  std::vector<std::size_t> malformed;          ///< lines, from 1, that are none of sha256sum, cut, or name a file again
};

/// Reads the text of SHA256SUMS.
[[nodiscard]] Sums parse_sums(std::string_view text);

}  // namespace bezierbench::bundle
