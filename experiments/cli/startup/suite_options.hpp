// SPDX-License-Identifier: MIT
// The suites that a command is given, the options that change them, and the curve sets that they name: files, or
// shipped sets by their ids.
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "experiments/cli/command.hpp"
#include "experiments/sample/curve_slice.hpp"
#include "experiments/suite/suite.hpp"
#include "experiments/suite/text/overrides.hpp"

namespace bezierbench::cli {

// The suites, curve sets and answers that come with the program: files beside it, not a part of it, so that whoever
// installs it can read them.

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

/// scripts/report of the source, for a program in its build folder, or of share/bezierbench, for an installed one.
/// Throws Failure(Exit::environment) where neither is there.
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

/// The ids of the shipped sets, sorted.
std::vector<std::string> shipped_curves();

/// A set that is not read from a file; `id` as in the tables of a bundle.
std::shared_ptr<const sample::LoadedSet> set_of(std::string_view id, curves::CurveSet given);

/// Reads the sets of all studies into Study::sets. An entry with `/` or a known extension is a file, relative to the
/// suite's; any other is the id of a shipped set; SET#GLOB takes the curves whose ids match. States their SHA-256 in
/// the study. Throws Failure(usage) for what is not a set, for a set without curves and for another SHA-256 than the
/// study states, and Failure(input_output) for a file that cannot be read.
void load_curves(std::vector<suite::Suite>& suites);

/// Names the files by copies that are to lie beside the suites, in a bundle, and returns these, name and text. Shipped
/// sets keep their ids.
std::vector<std::pair<std::string, std::string>> curves_beside(std::vector<suite::Suite>& suites);

/// Replaces the inputs of every study that can take curve sets by those of `files`, and drops the other studies. Throws
/// Failure(usage) where none is left.
void take_curves(std::vector<suite::Suite>& suites, const std::vector<std::string>& files);

/// Drops the studies of sets that take none of the curves of their sets. Throws Failure(usage) where none is left.
void drop_without_curves(std::vector<suite::Suite>& suites);

}  // namespace bezierbench::cli
