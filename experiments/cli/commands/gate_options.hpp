// SPDX-License-Identifier: MIT
// The gates of `compare` and `check`: their options, and their reports for pull requests and for continuous integration.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "experiments/cli/command.hpp"
#include "experiments/compare/gates.hpp"

namespace bezierbench::cli {

class GateOptions {
 public:
  /// `usual` are the gates that hold where none is named.
  explicit GateOptions(std::vector<compare::Gate> usual) : usual_(std::move(usual)) {}

  /// Adds --fail-on and --threshold.
  void add(Command& command);

  /// The rulings of the chosen gates on each comparison. Throws Failure(usage) for a word that is not a gate, a threshold
  /// that is not a number, and a named gate without a row to decide on.
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

}  // namespace bezierbench::cli
