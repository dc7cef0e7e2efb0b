// SPDX-License-Identifier: MIT
// A comparison of bundles for people.
#pragma once

#include <string>
#include <vector>

#include "experiments/compare/standings.hpp"

namespace bezierbench::cli {

/// The study and the axes that tell its cells apart, without those at their default of suites:
/// `quick-bezier, float, degree 12`.
std::string row_words(const compare::Inputs& inputs);

/// The verdict in one line; the differences between machines and builds; whether results differ, with the largest
/// change of each method and a replay of the largest of all; the counts of the verdicts on times. With `times`, the
/// times that changed and the ranks follow. With `all`, every row and every reading of the machines is listed.
std::string comparison_text(const compare::Comparison& comparison, bool times, bool all);

std::string standings_text(const std::vector<compare::Standing>& standings);

}  // namespace bezierbench::cli
