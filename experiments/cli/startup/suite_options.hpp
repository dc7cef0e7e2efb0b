// SPDX-License-Identifier: MIT
// The suites that a command is given, and the options that change them.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "experiments/cli/command.hpp"
#include "experiments/suite/text/overrides.hpp"

namespace bezierbench::cli {

class SuiteOptions {
 public:
  void add_suites(Command& command);
  /// Adds --seed, --trials, --set and --only.
  void add_changes(Command& command);
  /// Adds --curves.
  void add_curves(Command& command);
  /// Adds --no-timing.
  void add_no_timing(Command& command);

  /// The files of the suites. Throws Failure(usage) where there is none.
  [[nodiscard]] std::vector<std::filesystem::path> files() const;
  /// The suites as the options change them. Throws Failure for what is not a suite or not a value of an option.
  [[nodiscard]] std::vector<suite::Suite> read(const suite::Vocabulary& known) const;

 private:
  std::vector<std::string> words_;
  std::vector<std::string> curves_;
  std::optional<std::string> seed_;
  std::optional<std::string> trials_;
  suite::Overrides overrides_;
};

}  // namespace bezierbench::cli
