// SPDX-License-Identifier: MIT
// Whether two bundles agree bit for bit in everything that suite and seed determine.
#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <vector>

#include "experiments/bundle/check/method_digest.hpp"
#include "experiments/compare/rows.hpp"
#include "experiments/compare/side.hpp"

namespace bezierbench::compare {

/// One result of two rows, as in the files.
struct ResultPair {
  std::string column;
  std::string a;
  std::string b;
};

/// Two rows, one of each bundle, with the same inputs.
struct AccuracyRow {
  std::string file;
  Inputs inputs;
  bool identical;
  ResultPair first;  ///< the first result that differs; for identical rows the largest error or, without one, the first
  ResultPair shown;  ///< the largest error, in units of u p~ where both have it, if it differs; else `first`
  std::size_t line_a;
  std::size_t line_b;

  /// b over a of the shown result; infinite where that is not a ratio of numbers.
  [[nodiscard]] double growth() const;
};

/// How many rows of one method in one study have a partner, differ from it, or are in one bundle only.
struct RowCounts {
  std::size_t pairs = 0;
  std::size_t differing = 0;
  std::size_t only_a = 0;
  std::size_t only_b = 0;
};

struct AccuracyComparison {
  std::vector<AccuracyRow> rows;  ///< by file, and within a file in a's order
  std::size_t only_a = 0;         ///< rows without a partner
  std::size_t only_b = 0;
  std::map<bundle::Rows, RowCounts> methods;
  std::vector<std::string> left_out;  ///< files of both bundles whose rows do not determine their inputs

  [[nodiscard]] std::size_t differing() const;
};

/// Compares the deterministic tables. Bundles with different seeds have different inputs, so that no row has a partner.
/// For different suites only tables with a column `trials` are compared: the rows of any other table do not say how
/// many trials they are about.
[[nodiscard]] AccuracyComparison compare_accuracy(const Side& a, const Side& b);

/// How the results of one method changed.
struct MethodChange {
  std::string method;                         ///< empty for rows without a method
  std::size_t rows = 0;                       ///< pairs of rows
  std::vector<const AccuracyRow*> differing;  ///< those that differ, by descending growth; never empty
};

/// The methods whose results differ, the one with the largest growth first. The rows are those of `accuracy`.
[[nodiscard]] std::vector<MethodChange> method_changes(const AccuracyComparison& accuracy);

/// The worst_id of the input that `side` recorded for the cell and method of `inputs`, which can be replayed; empty where none was recorded.
[[nodiscard]] std::string recorded_input(const Side& side, const Inputs& inputs);

}  // namespace bezierbench::compare
