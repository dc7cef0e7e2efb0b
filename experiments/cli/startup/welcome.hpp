// SPDX-License-Identifier: MIT
#pragma once

#include <string>

namespace bezierbench::cli {

/// What the program says when it is called without a word: what one can do with it, each in one line of at most 80
/// characters, or in two on a narrower terminal.
std::string welcome();

}  // namespace bezierbench::cli
