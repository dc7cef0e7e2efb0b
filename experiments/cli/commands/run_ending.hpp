// SPDX-License-Identifier: MIT
// The last words of `run` and `merge`.
#pragma once

#include <string>
#include <vector>

#include "experiments/run/notes.hpp"
#include "experiments/run/run.hpp"

namespace bezierbench::cli {

/// Commands that can follow such a run, the most useful first, as they can be pasted.
std::vector<std::string> next_commands(const run::Outcome& outcome, const std::string& out);

/// Says what the run gave, where it is and what can be done with it.
void tell_ending(const run::Outcome& outcome, const std::string& out, run::Telling telling);

}  // namespace bezierbench::cli
