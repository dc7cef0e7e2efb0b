// SPDX-License-Identifier: MIT
// What a method is checked against: a bundle, another program, or a commit that is built for it; the times of two
// programs; and what was found of it: labelled lines, each with its evidence, and a verdict.
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "experiments/compare/comparison.hpp"
#include "experiments/compare/join.hpp"
#include "experiments/metric/order_statistics.hpp"
#include "experiments/run/run.hpp"
#include "experiments/suite/external.hpp"

namespace bezierbench::cli {

/// A bezierbench with its external methods.
struct TestedProgram {
  std::filesystem::path path;
  std::vector<std::string> arguments = {};  ///< --plugin FILE, for example
};

struct Against {
  bool is_bundle;
  std::string name;                   ///< for people
  std::filesystem::path bundle = {};  ///< its folder
  TestedProgram program = {};         ///< where it is not a bundle
};

/// What `--against WORD` names, the first that fits:
/// - a folder: a bundle;
/// - where `method` is a command: that command before the change;
/// - where `method` is a plug-in and the word names a file that ends in .so: that plug-in before the change;
/// - any other file: a program, which gets the external methods of `now`, this program;
/// - a commit of the repository around the current folder, whose program gets the same methods. It is built with the preset
///   `release` below $XDG_CACHE_HOME or ~/.cache, unless it was built before; `quiet` leaves out the message that says so.
/// `method` is null unless it is external. Throws Failure(Exit::usage) for any other word, and Failure(Exit::environment),
/// naming the file with the output, where the commit cannot be built.
Against find_against(const std::string& word, const TestedProgram& now, const suite::ExternalMethod* method,
                     bool quiet);

/// `PROGRAM run SUITE --out OUT --quiet MORE...`. A violated bound is not a failure, since the bundle records it.
/// Throws Failure(Exit::usage) where the program cannot be started or fails otherwise, and Failure(Exit::interrupted)
/// where a signal asked this program to end meanwhile.
void run_suite(const TestedProgram& program, const std::filesystem::path& suite, const std::filesystem::path& out,
               std::vector<std::string> more);

/// The times of one row of timing.csv, in nanoseconds per point; element k of both is pair k. Not empty.
struct PairedTimes {
  std::vector<double> before;
  std::vector<double> after;
  bool checked = true;  ///< whether every timed result was the judged one

  /// After over before, of the pairs.
  [[nodiscard]] metric::Interval ratio() const;
  /// Unresolved where there are too few pairs for an interval.
  [[nodiscard]] metric::Verdict verdict() const;
  /// As in timing.csv, where pairs are what repetitions are there.
  [[nodiscard]] std::string quality() const;
};

struct Programs {
  TestedProgram before;
  TestedProgram after;
  std::filesystem::path suite;    ///< a file with timing studies
  std::filesystem::path scratch;  ///< a folder for their bundles
};

/// Runs both programs `pairs` times, in turn, so that what changes on the machine affects both alike, and each pair of
/// runs gives one ratio; in every second pair the other program goes first. A pair is one observation, as a repetition
/// is in a race (experiments/race/race.hpp): every process has its own addresses of stack, heap and code, which may
/// change a time by more than the difference that is looked for. Rows that only one program has are left out. Throws
/// Failure where a program fails.
std::map<compare::Inputs, PairedTimes> paired_times(const Programs& programs, const std::string& method, int pairs);

/// Every function adds labelled lines and what is wrong.
struct Report {
  std::string method;
  bool all = false;                        ///< whether every detail is shown
  std::string lines = {};                  ///< below the verdict
  std::vector<std::string> findings = {};  ///< what is wrong, in a few words each; empty where nothing is

  /// A line and its details, the most important first: `shown` of them, if not all are.
  void add(const std::string& label, const std::string& text, const std::vector<std::string>& details = {},
           std::size_t shown = 3);

  /// The properties of every evaluator, decided again.
  void add_properties();
  /// The errors against the exact value in the bundle that `judged` wrote, and the bound. `cells` names the suite or
  /// bundle of these cells. Throws Failure(Exit::input_output) for a bundle that cannot be read.
  void add_errors(const std::filesystem::path& bundle, const std::string& cells, const run::Outcome& judged);
  /// Whether the bound and what else the method guarantees hold. `used` is the largest error over its bound; empty
  /// where no bound is stated.
  void add_bound(std::optional<double> used, const run::Outcome& judged);
  /// What changed between two bundles of the same cells, with rows of the method only: the build and the results.
  void add_changes(const std::string& name, const compare::Comparison& comparison);
  /// The counts of instructions that changed, the most costly first.
  void add_counts(const std::vector<compare::Row>& costs);
  /// Times by descending ratio; those with the verdict `same` only if all are shown.
  void add_times(const std::map<compare::Inputs, PairedTimes>& times, int pairs);

  /// The verdict, then the lines.
  [[nodiscard]] std::string text() const;
};

}  // namespace bezierbench::cli
