// SPDX-License-Identifier: MIT
// The words that options take, for completions. Each list is made when somebody asks for it.
#pragma once

#include "core/method.hpp"
#include "experiments/cli/command.hpp"

namespace bezierbench::cli {

/// The methods of one problem.
KnownValues methods_of(Problem problem);

/// The methods of every problem, conversions included.
KnownValues all_methods();

/// What --set takes: `key=` for every key that can be set, or `key=value` where the values are known.
std::vector<std::string> known_settings();

}  // namespace bezierbench::cli
