// SPDX-License-Identifier: MIT
// Resolved suites as TOML: what was run, with nothing left to defaults.
#pragma once

#include <span>
#include <string>

#include "experiments/suite/suite.hpp"

namespace bezierbench::suite {

/// Suites as TOML that parse_suites reads back to equal values, every key explicit, in a fixed order, doubles in
/// shortest decimal. Empty values are left out (methods: all that apply; title, modes, published: none). One suite is
/// written as people write it, with [suite] and [[study]], so that `run BUNDLE/suite.toml` repeats it; several are
/// written as [[suites]], each with its [[suites.study]].
std::string to_toml(std::span<const Suite> suites);

}  // namespace bezierbench::suite
