// SPDX-License-Identifier: MIT
// --damaged: a bundle whose files are not as SHA256SUMS lists them is used all the same, and what is printed says so.
#pragma once

#include <string>
#include <vector>

#include "experiments/bundle/check/checked_reader.hpp"
#include "experiments/cli/command.hpp"

namespace bezierbench::cli {

inline void add_damaged(Command& command, bool& asked) {
  command.flag("--damaged", asked, "use files that are not as SHA256SUMS lists them, and say so in the first line");
}

inline bundle::Damage damage_of(bool asked) { return asked ? bundle::Damage::told : bundle::Damage::refused; }

/// Prints one line, the first of standard output, that names these files; nothing where there are none.
void print_damage(const std::vector<std::string>& files);

}  // namespace bezierbench::cli
