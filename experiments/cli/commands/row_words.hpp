// SPDX-License-Identifier: MIT
// A row of a table in a few words, for people.
#pragma once

#include <string>

#include "experiments/compare/row_match.hpp"

namespace bezierbench::cli {

/// The study and the axes that tell its cells apart, without those at their default of suites:
/// `quick-bezier, float, degree 12`.
std::string row_words(const compare::Inputs& inputs);

}  // namespace bezierbench::cli
