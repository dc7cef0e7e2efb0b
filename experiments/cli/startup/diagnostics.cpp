// SPDX-License-Identifier: MIT
#include "experiments/cli/startup/diagnostics.hpp"

#include <cstdio>

#include "experiments/echo.hpp"

namespace bezierbench::cli {

void say(const std::string& text) {
  constexpr std::size_t longest = 2000;  // in bytes; a file may have a field of megabytes
  const auto end = text.find_last_not_of(" \n") + 1;
  const auto line = "bezierbench: " + shortened(std::string_view(text).substr(0, end), longest) + '\n';
  std::fputs(line.c_str(), stderr);
}

}  // namespace bezierbench::cli
