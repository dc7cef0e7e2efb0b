// SPDX-License-Identifier: MIT
// What was found of a method, and the text that says it.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "experiments/bundle/check/method_digest.hpp"
#include "experiments/cli/check/judged_cells.hpp"
#include "experiments/cli/check/paired_times.hpp"
#include "experiments/compare/side.hpp"
#include "experiments/run/run.hpp"

namespace bezierbench::cli {

/// A property that the method lost, with the first case.
struct LostProperty {
  std::string name;
  std::string statement;
  std::string first;
  std::size_t broken;
  std::size_t cases;
};

struct CheckedProperties {
  std::size_t count = 0;  ///< of those that the method must have
  std::size_t cases = 0;
  std::vector<LostProperty> lost;
};

/// A row of results that changed.
struct ChangedRow {
  std::string where;
  std::string column;
  std::string before;
  std::string after;
};

struct Comparison {
  std::string name;                             ///< what the method was checked against
  std::vector<compare::FactDifference> builds;  ///< differences that a time may come from
  std::size_t rows = 0;                         ///< with the same inputs
  std::vector<ChangedRow> changed;              ///< the largest growth first
  std::vector<bundle::Rows> other;              ///< results that are there on one side only, or in other numbers
  std::vector<PairedTime> times;
  int pairs = 0;          ///< of runs; 0 where nothing was timed
  std::string not_timed;  ///< why a program's times are not there; empty where they are
};

struct CheckReport {
  std::string method;
  std::string judged_in;  ///< whose cells these are, for people
  CheckedProperties properties;
  JudgedCells cells;
  run::Outcome judged;  ///< of the run over these cells: what it found wrong beside `cells`
  std::optional<Comparison> against;

  /// What is wrong, in a few words each; empty where nothing is.
  [[nodiscard]] std::vector<std::string> findings() const;
  /// The verdict, what it rests on, and the worst changes: ten lines, unless the terminal is narrow. With `all` every
  /// change has its line.
  [[nodiscard]] std::string text(bool all) const;
};

}  // namespace bezierbench::cli
