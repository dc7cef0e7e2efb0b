// SPDX-License-Identifier: MIT
// A comparison of bundles for people, and the gates of `compare` and `check`: their options, and their reports for
// pull requests and for continuous integration.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "experiments/cli/command.hpp"
#include "experiments/compare/gates.hpp"
#include "experiments/compare/standings.hpp"

namespace bezierbench::cli {

class GateOptions {
 public:
  /// `usual` are the gates that hold where none is named.
  explicit GateOptions(std::vector<compare::Gate> usual) : usual_(std::move(usual)) {}

  /// Adds --fail-on and --threshold.
  void add(Command& command);

  /// The rulings of the chosen gates on each comparison. Throws Failure(usage) for a word that is not a gate, a
  /// threshold that is not a number, and a named gate without a row to decide on.
  [[nodiscard]] std::vector<compare::GateReport> reports(const std::vector<compare::Comparison>& comparisons) const;

 private:
  std::vector<compare::Gate> usual_;
  std::string fail_on_;
  std::string threshold_ = "5%";
};

/// The findings of the gates that fail.
[[nodiscard]] std::vector<std::string> findings_of(const std::vector<compare::GateReport>& reports);

/// Formats of the reports, beside those of the command.
inline constexpr std::string_view markdown_format = "markdown";
inline constexpr std::string_view junit_format = "junit";

/// A table of the gates, and the rows that fail or are undecided. `others` are findings without rows.
[[nodiscard]] std::string markdown(const std::vector<compare::GateReport>& reports,
                                   const std::vector<std::string>& others = {});

/// JUnit's XML: a suite for each gate, a case for each row; an undecided one counts as skipped.
[[nodiscard]] std::string junit(const std::vector<compare::GateReport>& reports,
                                const std::vector<std::string>& others = {});

/// The study and the axes that tell its cells apart, without those at their default of suites:
/// `quick-bezier, float, degree 12`.
std::string row_words(const compare::Inputs& inputs);

/// The verdict in one line; the differences between machines and builds; whether results differ, with the largest
/// change of each method and a replay of the largest of all; the counts of the verdicts on times. With `times`, the
/// times that changed and the ranks follow. With `all`, every row and every reading of the machines is listed.
std::string comparison_text(const compare::Comparison& comparison, bool times, bool all);

std::string standings_text(const std::vector<compare::Standing>& standings);

}  // namespace bezierbench::cli
