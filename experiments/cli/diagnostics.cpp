// SPDX-License-Identifier: MIT
#include "experiments/cli/diagnostics.hpp"

#include <algorithm>
#include <cstdio>

namespace bezierbench::cli {

std::string one_line(std::string text) {
  std::ranges::replace_if(
      text, [](unsigned char c) { return c < 0x20 || c == 0x7f; }, ' ');
  text.erase(text.find_last_not_of(' ') + 1);
  return text;
}

void say(const std::string& text) { std::fputs((one_line("bezierbench: " + text) + '\n').c_str(), stderr); }

}  // namespace bezierbench::cli
