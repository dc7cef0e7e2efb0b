// SPDX-License-Identifier: MIT
// A comparison of bundles for people: machines and builds first, then accuracy, then times.
#pragma once

#include <string>
#include <vector>

#include "experiments/compare/comparison.hpp"

namespace bezierbench::cli {

/// The differences between machines and builds, and whether results differ, with the first input that shows it.
std::string differences_text(const compare::Side& a, const compare::Side& b, const compare::Pair& pair);

/// Counts of verdicts, and which of the two ratios to read.
std::string timing_summary(const compare::Pair& pair);

/// Every timing, race by race.
std::string timing_text(const compare::TimingComparison& timing);

/// The methods that changed their order, as far as intervals show it.
std::string rank_changes_text(const compare::TimingComparison& timing);

std::string standings_text(const std::vector<compare::Standing>& standings);

}  // namespace bezierbench::cli
