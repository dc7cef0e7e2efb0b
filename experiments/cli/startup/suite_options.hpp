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

// The suites, curve sets and answers that come with the program: files beside it, not a part of it, so that whoever installs it can read them.

/// The folder of the suites: share/bezierbench/suites beside the folder of an installed program; for a program in its
/// build folder `suites` there, a link that CMake makes to those of the source. Throws Failure(Exit::environment)
/// where neither is there.
std::filesystem::path suites_folder();

/// The folder of the shipped curve sets, likewise; the file of a set is ID.csv.
std::filesystem::path curves_folder();

/// The bundles of the shipped answers and of real curves, likewise.
std::filesystem::path answers_folder();
std::filesystem::path real_folder();

/// The ids of the suites in suites_folder(), in alphabetical order. The file of a suite is ID.toml.
std::vector<std::string> shipped_suites();

/// The first folder of PATH that has this program.
std::optional<std::filesystem::path> folder_on_path(std::string_view program);

/// The file that a word of the command line names: itself where it has a slash or ends in .toml, else the shipped suite
/// with this id. Throws Failure(Exit::usage) where there is none.
std::filesystem::path suite_file(const std::string& word);

/// scripts/report of the source, for a program in its build folder, or of share/bezierbench, for an installed one. Throws
/// Failure(Exit::environment) where neither is there.
std::filesystem::path report_script();

class SuiteOptions {
 public:
  void add_suites(Command& command);
  /// Adds --seed, --trials, --set and --only.
  void add_changes(Command& command);
  /// Adds --curves.
  void add_curves(Command& command);
  /// Adds --no-timing.
  void add_no_timing(Command& command);
  /// Adds --counts.
  void add_counts(Command& command);

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
