// SPDX-License-Identifier: MIT
// --damaged: uses a bundle although files differ from SHA256SUMS, and says so in the output.
#pragma once

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <string>
#include <vector>

#include "experiments/bundle/check/checked_reader.hpp"
#include "experiments/cli/command.hpp"
#include "reference/number/echo.hpp"

namespace bezierbench::cli {

inline void add_damaged(Command& command, bool& asked) {
  command.flag("--damaged", asked, "use files that differ from SHA256SUMS, and name them in the first line");
}

inline bundle::Damage damage_of(bool asked) { return asked ? bundle::Damage::told : bundle::Damage::refused; }

/// Prints one line that names these files, the first of standard output; prints nothing where there are none.
inline void print_damage(const std::vector<std::string>& files) {
  if (!files.empty())
    fmt::print("{}\n", printable(fmt::format("# DAMAGED, not as SHA256SUMS lists: {}", fmt::join(files, ", "))));
}

}  // namespace bezierbench::cli
