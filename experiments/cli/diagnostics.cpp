// SPDX-License-Identifier: MIT
#include "experiments/cli/diagnostics.hpp"

#include <algorithm>
#include <cstdio>

namespace bezierbench::cli {

void say(const std::string& text) {
  std::string line = "bezierbench: " + text;
  std::ranges::replace_if(
      line, [](unsigned char c) { return c < 0x20 || c == 0x7f; }, ' ');
  line.erase(line.find_last_not_of(' ') + 1);
  line += '\n';
  std::fputs(line.c_str(), stderr);
}

}  // namespace bezierbench::cli
