// SPDX-License-Identifier: MIT
// Manual pages in the language of man(7), one for each command.
#pragma once

#include <filesystem>
#include <string>

#include "experiments/cli/terminal/command_tree.hpp"

namespace bezierbench::cli {

/// The page of one command of the program, in section 1. `program` is the root of the tree.
std::string manual_page(const CommandNode& program, const CommandNode& command);

/// Writes the pages of all commands into a folder, which is made where it is absent: bezierbench-curve-eval.1. Throws
/// Failure(Exit::input_output).
void write_manual(const CommandNode& program, const std::filesystem::path& folder);

}  // namespace bezierbench::cli
