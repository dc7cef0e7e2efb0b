// SPDX-License-Identifier: MIT
// What was found of a method: labelled lines, each with its evidence, and a verdict.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "experiments/cli/check/paired_times.hpp"
#include "experiments/compare/side.hpp"
#include "experiments/run/run.hpp"

namespace bezierbench::cli {

struct Section {
  std::string label;
  std::string head;
  std::vector<std::string> details = {};  ///< the most important first
  std::size_t most = 3;                   ///< of the details that are shown without --all
};

/// Every function adds one section and what is wrong.
struct Report {
  std::string method;
  std::vector<Section> sections = {};
  std::vector<std::string> findings = {};  ///< what is wrong, in a few words each; empty where nothing is

  /// The properties of every evaluator, decided again.
  void add_properties();
  /// The errors against the exact value in the bundle that `judged` wrote, and the bound. `cells` is whose cells these
  /// are. Throws Failure(Exit::input_output) for a bundle that cannot be read.
  void add_errors(const std::filesystem::path& bundle, const std::string& cells, const run::Outcome& judged);
  /// Whether the bound and what else the method guarantees hold. `used` is the largest error over its bound; empty
  /// where no bound is stated.
  void add_bound(std::optional<double> used, const run::Outcome& judged);
  /// What changed from `before` to `after`, two bundles of the same cells: the build and the results.
  void add_changes(const std::string& name, const compare::Side& before, const compare::Side& after);
  /// Times by descending ratio. Without `all`, those with the verdict `same` are left out.
  void add_times(std::vector<PairedTime> times, int pairs, bool all);

  /// The verdict, then the sections; with `all`, every detail.
  [[nodiscard]] std::string text(bool all) const;
};

}  // namespace bezierbench::cli
