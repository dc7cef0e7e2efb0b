// SPDX-License-Identifier: MIT
// What a method is checked against.
#pragma once

#include <filesystem>
#include <string>

namespace bezierbench::cli {

struct Against {
  enum class Kind { program, bundle };

  Kind kind;
  std::string name;            ///< for people
  std::filesystem::path path;  ///< of the program or of the bundle's folder
};

/// Finds out what the user means: a folder is a bundle, a file a program, any other word a commit, which is built
/// unless it was. `quiet` leaves out the message that says so. Throws Failure(Exit::usage) for a word that is none of
/// these.
Against find_against(const std::string& word, bool quiet);

}  // namespace bezierbench::cli
