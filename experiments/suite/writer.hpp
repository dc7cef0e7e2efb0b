// SPDX-License-Identifier: MIT
// Resolved suites as TOML: what was run, with nothing left to defaults.
#pragma once

#include <span>
#include <string>

#include "experiments/suite/suite.hpp"

namespace bezierbench::suite {

/// TOML that parse_suites reads back to equal values, every field explicit, in a fixed order; what is empty
/// (methods: all that apply; title, modes, published: none) is left out. One suite is written as people write it,
/// [suite] and
/// [[study]], so that `run BUNDLE/suite.toml` repeats it; several as [[suites]], each with its [[suites.study]].
/// Doubles in shortest decimal.
std::string to_toml(std::span<const Suite> suites);

}  // namespace bezierbench::suite
