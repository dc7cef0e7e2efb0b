// SPDX-License-Identifier: MIT
// The help of a command, in the width of the terminal.
#pragma once

#include <string>

#include "experiments/cli/terminal/command_tree.hpp"

namespace bezierbench::cli {

/// What is typed, in one line: "bezierbench merge BUNDLE... --out FOLDER [OPTION...]".
std::string synopsis(const CommandNode& command);

/// An option as in the list of options: "--out FOLDER", "SUITE...".
std::string spelling(const OptionNode& option);

/// Standard output decides width and colours; without a terminal lines have at most 80 characters.
std::string help_text(const CommandNode& command);

}  // namespace bezierbench::cli
