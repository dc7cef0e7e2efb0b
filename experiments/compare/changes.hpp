// SPDX-License-Identifier: MIT
// What changed between two bundles, worst first, for people.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "experiments/compare/accuracy.hpp"

namespace bezierbench::compare {

/// The result that shows how a pair of rows differs: the largest error if that differs, else the first column that
/// does.
[[nodiscard]] ResultPair shown_change(const AccuracyRow& row);

/// b over a of that result; infinite where it is not a ratio of numbers.
[[nodiscard]] double growth(const AccuracyRow& row);

/// How the results of one method changed.
struct MethodChange {
  std::string method;                         ///< empty for rows without a method
  std::size_t rows = 0;                       ///< pairs of rows
  std::vector<const AccuracyRow*> differing;  ///< those that differ, by growth, the largest first; never empty
};

/// The methods whose results differ, the one with the largest growth first. The rows are those of `accuracy`.
[[nodiscard]] std::vector<MethodChange> method_changes(const AccuracyComparison& accuracy);

}  // namespace bezierbench::compare
