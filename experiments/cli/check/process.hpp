// SPDX-License-Identifier: MIT
// Another program, run to its end.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace bezierbench::cli {

struct ProcessPlace {
  std::filesystem::path folder = {};  ///< where it runs; empty: here
  std::filesystem::path log = {};     ///< file to which all its output is appended; empty: see Ended::output
  bool silent = false;                ///< drops its standard error
};

inline constexpr int cannot_be_started = 127;  ///< in place of an exit code, as in a shell

struct Ended {
  int code;            ///< its exit code; 128 + the number of the signal that ended it; or cannot_be_started
  std::string output;  ///< standard output, unless it went to a log
};

/// Runs the program `words[0]`, looked up in PATH unless it has a slash, with `words` as its arguments. Throws
/// Failure(Exit::interrupted) where a signal asked this program to end meanwhile, and Failure(Exit::input_output) where
/// the log cannot be written.
Ended run_process(const std::vector<std::string>& words, const ProcessPlace& place = {});

}  // namespace bezierbench::cli
