// SPDX-License-Identifier: MIT
// What a method is checked against: a bundle, another program, or a commit that is built for it; and the times of two
// programs.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "experiments/compare/join.hpp"
#include "experiments/metric/order_statistics.hpp"
#include "experiments/metric/verdict.hpp"
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

/// `PROGRAM run SUITE --out OUT --quiet MORE...`. A violated bound is not a failure, since the bundle records it. Throws
/// Failure(Exit::usage) where the program cannot be started or fails otherwise, and Failure(Exit::interrupted) where a
/// signal asked this program to end meanwhile.
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
/// runs gives one ratio; in every second pair the other program goes first. A pair is one observation, as a repetition is
/// in a race (experiments/race/race.hpp): every process has its own addresses of stack, heap and code, which may
/// change a time by more than the difference that is looked for. Rows that only one program has are left out. Throws
/// Failure where a program fails.
std::map<compare::Inputs, PairedTimes> paired_times(const Programs& programs, const std::string& method, int pairs);

}  // namespace bezierbench::cli
