// SPDX-License-Identifier: MIT
// What a method is checked against: a bundle, another program, or a commit that is built for it.
#pragma once

#include <filesystem>
#include <string>

namespace bezierbench::cli {

struct Against {
  bool is_bundle;
  std::string name;            ///< for people
  std::filesystem::path path;  ///< of the program or of the bundle's folder
};

/// A folder is a bundle, a file is a program, and any other word is a commit of the repository around the current
/// folder. A commit is built with the preset `release` below $XDG_CACHE_HOME or ~/.cache, unless it was built before;
/// `quiet` leaves out the message that says so. Throws Failure(Exit::usage) for a word that is none of these, and
/// Failure(Exit::environment), naming the file with the output, where the commit cannot be built.
Against find_against(const std::string& word, bool quiet);

/// `PROGRAM run SUITE --out OUT --quiet`. A violated bound is not a failure, since the bundle records it. Throws
/// Failure(Exit::usage) where the program cannot be started or fails otherwise, and Failure(Exit::interrupted) where a
/// signal asked this program to end meanwhile.
void run_suite(const std::filesystem::path& program, const std::filesystem::path& suite,
               const std::filesystem::path& out);

}  // namespace bezierbench::cli
