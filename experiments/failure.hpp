// SPDX-License-Identifier: MIT
// The exception of experiments: an exit code and one line for the user.
#pragma once

#include <fmt/format.h>

#include <stdexcept>
#include <string>
#include <utility>

namespace bezierbench {

/// Exit codes that users and scripts rely on.
enum class Exit : int {
  fine = 0,
  finding = 1,        ///< a gate failed, bytes differ, a bound was violated
  usage = 2,          ///< command line or suite file
  environment = 3,    ///< processor, floating-point environment, missing package
  input_output = 4,   ///< no space, no permission, unreadable or malformed data file
  interrupted = 130,  ///< resumable
};

/// Ends the program with `exit` and prints what(), one line that names the file and the remedy.
class Failure : public std::runtime_error {
 public:
  Failure(Exit exit, const std::string& line) : std::runtime_error(line), exit_(exit) {}
  /// The line as fmt::format makes it.
  template <class First, class... Rest>
  Failure(Exit exit, fmt::format_string<First, Rest...> line, First&& first, Rest&&... rest)
      : Failure(exit, fmt::format(line, std::forward<First>(first), std::forward<Rest>(rest)...)) {}
  [[nodiscard]] Exit exit() const { return exit_; }

 private:
  Exit exit_;
};

}  // namespace bezierbench
