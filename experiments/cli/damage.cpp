// SPDX-License-Identifier: MIT
#include "experiments/cli/damage.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cstdio>

#include "experiments/cli/diagnostics.hpp"

namespace bezierbench::cli {

void print_damage(const std::vector<std::string>& files) {
  if (!files.empty())
    fmt::print("{}\n", one_line(fmt::format("# DAMAGED, not as SHA256SUMS lists: {}", fmt::join(files, ", "))));
}

}  // namespace bezierbench::cli
