// SPDX-License-Identifier: MIT
// Whether a bundle is what it says that it is.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace bezierbench::bundle {

/// What the suites of a bundle ask of the rest of it.
struct Expected {
  std::vector<std::string> suites;  ///< their ids
  std::uint64_t seed = 0;
  std::vector<std::string> studies;              ///< their ids
  std::vector<std::vector<std::string>> tables;  ///< one of each list must be there
};

/// From the text of suite.toml and its name, for messages. Throws Failure where the text is no suite.
using SuiteReader = std::function<Expected(const std::string& text, const std::string& file_name)>;

/// What is wrong with a bundle's files, one line each, in a fixed order; empty where all is well. Looks at bundle.json,
/// readable, `complete`, and of this suite.toml; at the files that every bundle has and those that its suites ask for;
/// at every listed file; the accuracy digest, digests.csv line by line, and the checksums; files and folders that are not the bundle's; the
/// schemas of both JSON files and of every table; rows in which a proved bound was broken, what was timed was not what
/// was judged, or whose study is not in suite.toml. For a folder that is no bundle, one line that says so. Throws
/// Failure(Exit::input_output) for no folder or a file that cannot be read.
[[nodiscard]] std::vector<std::string> verify(const std::filesystem::path& path, const SuiteReader& read_suites);

}  // namespace bezierbench::bundle
