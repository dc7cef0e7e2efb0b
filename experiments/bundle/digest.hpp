// SPDX-License-Identifier: MIT
// Checksums, of bytes and of files as coreutils' sha256sum writes them.
#pragma once

#include <cstddef>
#include <filesystem>
#include <map>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace bezierbench::bundle {

/// SHA-256 as 64 lower-case hexadecimal digits.
[[nodiscard]] std::string sha256_hex(std::string_view bytes);

/// One line as coreutils' sha256sum writes it, line end included. Throws Failure(Exit::input_output) for a name with a
/// line end or backslash, which that format would have to escape.
[[nodiscard]] std::string sha256sum_line(std::string_view name, std::string_view bytes);

/// The lines of the named files of `directory`, sorted by name as bytes. Throws Failure(Exit::input_output) where a
/// file cannot be read.
[[nodiscard]] std::string sha256sums(const std::filesystem::path& directory, std::span<const std::string> names);

// SHA256SUMS: the list of a bundle's files with their checksums.

struct Sums {
  std::map<std::string, std::string> digests;  ///< by file name
  std::vector<std::size_t> malformed;          ///< lines, from 1, that are invalid, cut, or repeat a name
};

/// Parses the text of SHA256SUMS.
[[nodiscard]] Sums parse_sums(std::string_view text);

}  // namespace bezierbench::bundle
