// SPDX-License-Identifier: MIT
// What was found of a method: labelled lines, each with its evidence, and a verdict.
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "experiments/cli/check/programs.hpp"
#include "experiments/compare/comparison.hpp"
#include "experiments/run/run.hpp"

namespace bezierbench::cli {

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
