// SPDX-License-Identifier: MIT
// A comparison of bundles for people: machines and builds first, then accuracy, then times.
#pragma once

#include <string>
#include <vector>

#include "experiments/compare/comparison.hpp"

namespace bezierbench::cli {

/// What the comparison found, in one line.
std::string verdict_line(const compare::Pair& pair);

/// The differences between machines and builds, and whether results differ: the largest change of each method, or with
/// `all` each row that differs and each reading of the machines, and an input that shows the largest of all.
std::string differences_text(const compare::Side& a, const compare::Side& b, const compare::Pair& pair, bool all);

/// Counts of verdicts, and which of the two ratios to read.
std::string timing_summary(const compare::Pair& pair);

/// The timings that are certainly slower or faster, the slowest first.
std::string changed_times_text(const compare::Pair& pair);

/// Every timing, in the order of a.
std::string timing_text(const compare::TimingComparison& timing);

/// The methods that changed their order, as far as both bundles show it.
std::string rank_changes_text(const compare::TimingComparison& timing);

std::string standings_text(const std::vector<compare::Standing>& standings);

}  // namespace bezierbench::cli
