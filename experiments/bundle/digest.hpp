// SPDX-License-Identifier: MIT
// Checksums: of files as coreutils' sha256sum writes them, and the one that says whether two bundles agree bit for bit.
#pragma once

#include <array>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>

namespace bezierbench::bundle {

/// The files of a bundle that suite and seed determine to the last bit, and no others: what the accuracy digest is of.
inline constexpr std::array<std::string_view, 14> deterministic_files{
    "accuracy.csv",   "conversion.csv",    "scorecard.csv",  "worst.csv",
    "search.csv",     "derivative.csv",    "arc_length.csv", "inverse_arc_length.csv",
    "projection.csv", "interpolation.csv", "fitting.csv",    "fitting_example.csv",
    "spacing.csv",    "subdivision.csv"};

/// SHA-256 as 64 lower-case hexadecimal digits.
[[nodiscard]] std::string sha256_hex(std::string_view bytes);

/// One line as coreutils' sha256sum writes it, line end included. Throws Failure(Exit::input_output) for a name with a
/// line end or backslash, which that format would have to escape.
[[nodiscard]] std::string sha256sum_line(std::string_view name, std::string_view bytes);

/// The lines of the named files of `directory`, sorted by name as bytes. Throws Failure(Exit::input_output) where a
/// file cannot be read.
[[nodiscard]] std::string sha256sums(const std::filesystem::path& directory, std::span<const std::string> names);

/// SHA-256 of the sha256sum lines of the deterministic files present in `bundle`, sorted by name.
[[nodiscard]] std::string accuracy_digest(const std::filesystem::path& bundle);

}  // namespace bezierbench::bundle
