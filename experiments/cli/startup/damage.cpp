// SPDX-License-Identifier: MIT
#include "experiments/cli/startup/damage.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cstdio>

#include "experiments/echo.hpp"

namespace bezierbench::cli {

void print_damage(const std::vector<std::string>& files) {
  if (!files.empty())
    fmt::print("{}\n", printable(fmt::format("# DAMAGED, not as SHA256SUMS lists: {}", fmt::join(files, ", "))));
}

}  // namespace bezierbench::cli
