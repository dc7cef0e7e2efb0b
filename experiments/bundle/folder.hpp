// SPDX-License-Identifier: MIT
// The contents of a bundle's folder, and the file names that have a meaning there.
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
  std::vector<std::string> files;        ///< regular files
  std::vector<std::string> temporaries;  ///< temporary files of write_file, whose writer is at work or was killed
  std::vector<std::string> others;       ///< folders, links and devices, blocks/ among them
};

/// Whether `path`, inside a bundle, is a folder; false where nothing has this name. Throws Failure(Exit::input_output)
/// for anything else, also for a link to a folder: a stranger's bundle must not lead out of its folder.
[[nodiscard]] bool is_inner_folder(const std::filesystem::path& path);

/// Whether anything has this name, also a link to nothing.
[[nodiscard]] bool is_there(const std::filesystem::path& path);

/// The contents of the folder `path`, without those of its subfolders. Throws Failure(Exit::input_output) where it
/// cannot be listed.
[[nodiscard]] Folder list_folder(const std::filesystem::path& path);

}  // namespace bezierbench::bundle
