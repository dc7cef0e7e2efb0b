// SPDX-License-Identifier: MIT
// What may stand at the end of a command line. The shells' functions, in completions/, ask for it by a hidden command.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "experiments/cli/terminal/command_tree.hpp"

namespace bezierbench::cli {

/// What may be typed instead of the last of `words`, which may be empty; the words before it are complete, and the name
/// of the program is not among them. Each entry is `WORD`, or `WORD<tab>MEANING`, or for names that the shell knows
/// ":files" or ":folders".
std::vector<std::string> completions(const CommandNode& program, std::span<const std::string> words);

}  // namespace bezierbench::cli
