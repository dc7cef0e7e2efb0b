// SPDX-License-Identifier: MIT
// What lies in a bundle's folder, and the names that have a meaning of their own there.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace bezierbench::bundle {

inline constexpr std::string_view manifest_name = "bundle.json";
inline constexpr std::string_view sums_name = "SHA256SUMS";
inline constexpr std::string_view blocks_name = "blocks";

/// Names in a folder, each list sorted by name as bytes.
struct Folder {
  std::vector<std::string> files;        ///< regular ones
  std::vector<std::string> temporaries;  ///< write_file's, of a writer at work or killed
  std::vector<std::string> others;       ///< folders, links, devices; blocks/ among them
};

/// Whether `path`, inside a bundle, is a folder; false where there is nothing. Throws Failure(Exit::input_output) for
/// anything else, a link to a folder too: what a stranger's bundle says must not lead out of it.
[[nodiscard]] bool is_inner_folder(const std::filesystem::path& path);

/// Whether anything has this name, a link that leads nowhere included.
[[nodiscard]] bool is_there(const std::filesystem::path& path);

/// Lists `path`, not what is below. Throws Failure(Exit::input_output) where that cannot be done.
[[nodiscard]] Folder list_folder(const std::filesystem::path& path);

}  // namespace bezierbench::bundle
