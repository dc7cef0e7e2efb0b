// SPDX-License-Identifier: MIT
#pragma once

#include <string>

namespace bezierbench::cli {

/// `text` as one word of a command line that can be pasted into a shell.
std::string shell_word(const std::string& text);

/// The program as it was called, for commands that are printed.
std::string this_program();

}  // namespace bezierbench::cli
