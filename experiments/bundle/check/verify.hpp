// SPDX-License-Identifier: MIT
// Checks that a bundle is intact and consistent.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace bezierbench::bundle {

/// What the suites of a bundle say of its other files.
struct Expected {
  std::vector<std::string> suites;  ///< their ids
  std::uint64_t seed = 0;
  std::vector<std::string> studies;  ///< their ids
};

/// Reads the text of suite.toml; the second argument is its name, for messages. Throws Failure where the text is not a
/// suite.
using SuiteReader = std::function<Expected(const std::string& text, const std::string& file_name)>;

/// What is wrong with a bundle's files, one line each, in a fixed order; empty where nothing is. Checks that
/// bundle.json can be read, is `complete` and belongs to this suite.toml; that the files are there which every bundle
/// has; every listed file, the accuracy digest, digests.csv line by line, and the checksums; that no other files or
/// folders are there; that every table is CSV; and that no row says that a bound or a promise was broken or that timed
/// output differed from the judged one, or names a study that is not in suite.toml. It finds accidents, not forgeries:
/// whoever changes rows can make their digests and checksums, too. A folder that is not a bundle gives one line that
/// says so. Throws Failure(Exit::input_output) where `path` is not a folder or a file cannot be read.
/// Blocks beside a complete bundle are a finding, unless other runs may be at work there: those tidy up in turn.
[[nodiscard]] std::vector<std::string> verify(const std::filesystem::path& path, const SuiteReader& read_suites,
                                              bool beside_other_runs = false);

}  // namespace bezierbench::bundle
