// SPDX-License-Identifier: MIT
// The program of another commit of the repository around the current folder.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

namespace bezierbench::cli {

struct Commit {
  std::string id;                    ///< in full
  std::filesystem::path repository;  ///< its top folder
};

/// The commit that git finds under `name`; empty where there is none, no repository or no git.
std::optional<Commit> find_commit(const std::string& name);

/// The folder with the sources and the build of a commit: below $XDG_CACHE_HOME or ~/.cache, so that it is built once.
/// Throws Failure(Exit::environment) where neither is known.
std::filesystem::path folder_of(const Commit& commit);

/// The file beside it with the output of the build.
std::filesystem::path log_of(const Commit& commit);

/// Builds the program of a commit with the preset `release` and returns its path. Throws Failure(Exit::environment)
/// where that fails, naming the file with the output.
std::filesystem::path build(const Commit& commit);

}  // namespace bezierbench::cli
